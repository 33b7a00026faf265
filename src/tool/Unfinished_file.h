// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file in the making, under a name of its own beside the one that it is to get.
// Invariant: it is gone when the object is, and when any signal that can be caught ends the program, unless it was
// renamed. One at a time.

#ifndef BOUNDING_ARCS_TOOL_UNFINISHED_FILE_H
#define BOUNDING_ARCS_TOOL_UNFINISHED_FILE_H

#include <string>

#include <sys/stat.h>

namespace bounding_arcs_tool {

class Unfinished_file {
 public:
  /// Creates the file. All that fails leaves errno and descriptor() < 0.
  /// \param old what it will replace, whose mode, and owner as far as that is allowed, it takes over; or nullptr
  Unfinished_file(const std::string& folder, const struct stat* old);
  ~Unfinished_file();
  Unfinished_file(const Unfinished_file&) = delete;
  Unfinished_file& operator=(const Unfinished_file&) = delete;

  [[nodiscard]] int descriptor() const { return descriptor_; }
  /// Closes the file and gives it its name in the folder.
  /// \return whether both went well; otherwise errno says why not
  [[nodiscard]] bool rename_to(const std::string& name);

 private:
  int folder_, descriptor_ = -1;
};

}  // namespace bounding_arcs_tool

#endif
