// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is told of work whose steps are not known.

#ifndef BOUNDING_ARCS_TOOL_ELAPSED_LINE_H
#define BOUNDING_ARCS_TOOL_ELAPSED_LINE_H

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bounding_arcs_tool {

/// Shows "WHAT: 5 s" on standard error while that is a terminal and the work takes more than a second. Nothing else is
/// to be written while it is there.
/// \code
/// const Elapsed_line elapsed("finding the axis");
/// \endcode
class Elapsed_line {
 public:
  explicit Elapsed_line(std::string what);
  ~Elapsed_line();  ///< wipes the line
  Elapsed_line(const Elapsed_line&) = delete;
  Elapsed_line& operator=(const Elapsed_line&) = delete;

 private:
  void show();

  std::string what_;
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace bounding_arcs_tool

#endif
