// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ordered_output.h"

#include <utility>

namespace bounding_arcs_tool {

void Ordered_output::put(std::size_t place, std::string& text, bool is_last) {
  std::unique_lock<std::mutex> lock(mutex_);
  if (place != next_ && is_last && waiting_bytes_ + text.size() <= MOST_WAITING) {
    waiting_bytes_ += text.size();
    waiting_.emplace(place, std::move(text));
    text.clear();
    return;
  }
  turn_.wait(lock, [&] { return has_stopped_ || place == next_; });
  write(text);
  text.clear();
  if (is_last) {
    ++next_;
    for (auto first = waiting_.begin(); first != waiting_.end() && first->first == next_; ++next_) {
      write(first->second);
      waiting_bytes_ -= first->second.size();
      first = waiting_.erase(first);
    }
  }
  if (!has_stopped_) has_stopped_ = !out_.flush();
  turn_.notify_all();
}

void Ordered_output::write(const std::string& text) {
  if (!has_stopped_) out_.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void Ordered_output::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  has_stopped_ = true;
  turn_.notify_all();
}

bool Ordered_output::has_stopped() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return has_stopped_;
}

}  // namespace bounding_arcs_tool
