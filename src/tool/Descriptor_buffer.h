// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A stream buffer over a file descriptor, which keeps the cause of the first write that failed: standard file streams
// forget it.

#ifndef BOUNDING_ARCS_TOOL_DESCRIPTOR_BUFFER_H
#define BOUNDING_ARCS_TOOL_DESCRIPTOR_BUFFER_H

#include <streambuf>
#include <vector>

namespace bounding_arcs_tool {

class Descriptor_buffer : public std::streambuf {
 public:
  /// Writes to a descriptor that stays open as long as the buffer is used; does not close it.
  explicit Descriptor_buffer(int descriptor);

  /// What errno was when a write failed for the first time, 0 if none did.
  [[nodiscard]] int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override;
  std::streamsize xsputn(const char* bytes, std::streamsize size) override;
  int sync() override;

 private:
  void write(const char* from, const char* end);

  std::vector<char> bytes_;
  int descriptor_;
  int error_ = 0;
};

}  // namespace bounding_arcs_tool

#endif
