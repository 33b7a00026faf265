// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_file.h"

#include "Curve_file.h"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>

#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what) {
  const std::string cause = errno != 0 ? std::strerror(errno) : "unknown cause";
  throw Input_error(path.empty() || path == "-" ? "standard output" : path, what, cause);
}

// What is to be removed when a signal ends the program: one file, as only one is written at a time.
constexpr std::size_t LONGEST_PATH = 4096;
char unfinished[LONGEST_PATH] = "";

extern "C" void remove_unfinished(int signal) {
  if (unfinished[0] != '\0') ::unlink(unfinished);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void remove_at_signals(const std::string& path) {
  if (path.size() >= LONGEST_PATH) return;
  std::strcpy(unfinished, path.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU})
    if (std::signal(signal, remove_unfinished) == SIG_IGN) std::signal(signal, SIG_IGN);  // as who started this wants it
}

}  // namespace

Output_file::Output_file(const std::string& path) : path_(path), stream_(&std::cout) {
  errno = 0;  // fail() reports the cause of the first write that fails, which may be long before commit()
  if (path_.empty() || path_ == "-") return;
  std::error_code ignored;
  const auto kind = std::filesystem::status(path_, ignored).type();
  if (kind == std::filesystem::file_type::directory) throw Input_error(path_, "cannot write", "it is a directory");
  // A device or a pipe is written in place; a link is followed, so that the file it names is the one replaced.
  if (kind == std::filesystem::file_type::regular) path_ = std::filesystem::canonical(path_, ignored).string();
  if (kind == std::filesystem::file_type::regular || kind == std::filesystem::file_type::not_found)
    temporary_ = path_ + ".part" + std::to_string(::getpid());
  if (!temporary_.empty()) remove_at_signals(temporary_);
  errno = 0;
  file_.open(temporary_.empty() ? path_ : temporary_, std::ios::binary | std::ios::trunc);
  if (!file_) {
    temporary_.clear();
    fail(path_, "cannot write");
  }
  stream_ = &file_;
}

Output_file::~Output_file() {
  if (temporary_.empty()) return;
  file_.close();
  std::remove(temporary_.c_str());
  unfinished[0] = '\0';
}

void Output_file::commit() {
  stream_->flush();
  if (!*stream_) fail(path_, "cannot write");
  if (stream_ != &file_) return;
  file_.close();
  if (!file_) fail(path_, "cannot write");
  if (temporary_.empty()) return;
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, "cannot write");
  unfinished[0] = '\0';
  temporary_.clear();
}

}  // namespace bounding_arcs_tool
