// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What several threads make of blocks, written in the order of the blocks.

#ifndef BOUNDING_ARCS_TOOL_STREAM_ORDERED_OUTPUT_H
#define BOUNDING_ARCS_TOOL_STREAM_ORDERED_OUTPUT_H

#include <condition_variable>
#include <cstddef>
#include <map>
#include <mutex>
#include <ostream>
#include <string>

namespace bounding_arcs_tool {

/// Invariant: texts of at most MOST_WAITING bytes together wait for an earlier block. The thread of the first block
/// that is not written never waits, so that all get on.
class Ordered_output {
 public:
  static constexpr std::size_t MOST_WAITING = std::size_t(1) << 22;  ///< 4 MiB

  explicit Ordered_output(std::ostream& out) : out_(out) {}

  /// Takes a part of what belongs to a block, and empties it: it is written before this returns, or waits.
  /// \param place of the block, from 0 without gaps
  void put(std::size_t place, std::string& text, bool is_last);
  /// Lets nobody wait any longer, and writes nothing more.
  void stop();
  /// Whether it was stopped, or something could not be written.
  [[nodiscard]] bool has_stopped();

 private:
  void write(const std::string& text);

  std::ostream& out_;
  std::size_t next_ = 0;  // the first block that is not written
  bool has_stopped_ = false;
  std::map<std::size_t, std::string> waiting_;  // by place
  std::size_t waiting_bytes_ = 0;
  std::mutex mutex_;
  std::condition_variable turn_;
};

}  // namespace bounding_arcs_tool

#endif
