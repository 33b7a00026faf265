// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lines of a file or of standard input, given out in blocks to any number of threads. A block is what one read
// brings, so that a line that comes alone is answered before the next one comes.

#ifndef BOUNDING_ARCS_TOOL_STREAM_LINE_SOURCE_H
#define BOUNDING_ARCS_TOOL_STREAM_LINE_SOURCE_H

#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

/// Longest line in bytes, 16 MiB, some 200 000 Bezier pieces.
constexpr std::size_t LONGEST_LINE = std::size_t(1) << 24;

struct Line {
  std::size_t number = 0;    ///< from 1, blank ones counted
  std::string text = {};     ///< without the line's end
  bool is_too_long = false;  ///< then the text is empty
};

struct Line_block {
  std::size_t place = 0;  ///< among the blocks, from 0 without gaps
  std::vector<Line> lines;
};

/// Invariant: what is kept between two blocks is less than LONGEST_LINE and one read.
class Line_source {
 public:
  /// \param path a file, or "-" for standard input
  /// \throws Input_error when it cannot be opened
  explicit Line_source(const std::string& path);
  ~Line_source();
  Line_source(const Line_source&) = delete;
  Line_source& operator=(const Line_source&) = delete;

  /// The next lines that are not blank, at least one. Threads may call it at the same time.
  /// \return false when there are no more
  /// \throws Input_error when the file cannot be read
  [[nodiscard]] bool next(Line_block& block);
  /// The lines so far, blank ones not counted.
  [[nodiscard]] std::size_t number_of_records() const { return records_; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  [[nodiscard]] std::size_t read_some();
  void take(std::string_view text, std::vector<Line>& lines);
  void end_line(std::vector<Line>& lines);

  std::string name_;
  int descriptor_;
  bool is_at_end_ = false;
  std::vector<char> bytes_;
  Line line_{1};  // the one that is not complete
  std::size_t blocks_ = 0, records_ = 0;
  std::mutex mutex_;
};

}  // namespace bounding_arcs_tool

#endif
