// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where results go: standard output, or a file that appears whole or not at all.

#ifndef BOUNDING_ARCS_TOOL_OUTPUT_FILE_H
#define BOUNDING_ARCS_TOOL_OUTPUT_FILE_H

#include "Descriptor_buffer.h"
#include "Unfinished_file.h"

#include <memory>
#include <optional>
#include <ostream>
#include <string>

namespace bounding_arcs_tool {

/// Links are followed. A file is written beside the one it replaces and takes over its mode; the name then stands for
/// a new file, so other hard links to the old one keep that. Devices, pipes and descriptors such as /dev/stdout are
/// written in place.
class Output_file {
 public:
  /// \param path a file, or "" or "-" for standard output
  /// \throws Input_error when it cannot be written, or is a file without permission to write for anyone, the superuser
  ///   included
  explicit Output_file(const std::string& path);
  ~Output_file();  ///< removes what was written unless commit() came before
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  [[nodiscard]] std::ostream& stream() { return *stream_; }
  /// Makes the file appear under its name. \throws Input_error when something could not be written
  void commit();

 private:
  int opened(const std::string& path);
  int opened_beside(const std::string& path, const struct stat* old);
  [[noreturn]] void fail(int cause) const;

  std::string path_, name_;                      // as given; in its folder, with links followed
  std::unique_ptr<Unfinished_file> unfinished_;  // none where the target is written in place
  int in_place_ = -1;                            // the descriptor of a device or pipe
  std::optional<Descriptor_buffer> buffer_;
  std::optional<std::ostream> stream_;
};

}  // namespace bounding_arcs_tool

#endif
