// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Elapsed_line.h"

#include <chrono>
#include <cstdio>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace bounding_arcs_tool {

Elapsed_line::Elapsed_line(std::string what) : what_(std::move(what)) {
  if (::isatty(STDERR_FILENO) == 0) return;
  try {
    thread_ = std::thread([this] { show(); });
  } catch (const std::system_error&) {
    // no thread is to be had: the work goes on without the line
  }
}

Elapsed_line::~Elapsed_line() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  over_.notify_one();
  thread_.join();
}

void Elapsed_line::show() {
  using std::chrono::seconds;
  std::unique_lock<std::mutex> lock(mutex_);
  const auto start = std::chrono::steady_clock::now();
  int gone = 0;
  while (!over_.wait_until(lock, start + seconds(gone + 1), [this] { return is_over_; })) {
    std::fprintf(stderr, "\r%s: %d s\033[K", what_.c_str(), ++gone);
    std::fflush(stderr);
  }
  if (gone > 0) std::fprintf(stderr, "\r\033[K");
}

}  // namespace bounding_arcs_tool
