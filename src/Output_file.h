// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where results go: standard output, or a file that appears whole or not at all.

#ifndef BOUNDING_ARCS_TOOL_OUTPUT_FILE_H
#define BOUNDING_ARCS_TOOL_OUTPUT_FILE_H

#include <fstream>
#include <ostream>
#include <string>

namespace bounding_arcs_tool {

class Output_file {
 public:
  /// \param path a file, or "" or "-" for standard output
  /// \throws Input_error when it cannot be written
  explicit Output_file(const std::string& path);
  ~Output_file();  ///< removes what was written unless commit() came before
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  [[nodiscard]] std::ostream& stream() { return *stream_; }
  /// Makes the file appear under its name. \throws Input_error when something could not be written
  void commit();

 private:
  std::string path_, temporary_;  // temporary_ is empty where the target is written in place
  std::ofstream file_;
  std::ostream* stream_;
};

}  // namespace bounding_arcs_tool

#endif
