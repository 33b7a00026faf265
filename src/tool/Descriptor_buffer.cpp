// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Descriptor_buffer.h"

#include <cerrno>
#include <cstddef>

#include <poll.h>
#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

constexpr std::size_t SIZE = std::size_t(1) << 16;

// Waits until a descriptor that does not block, as some terminals and pipes are set to, takes more.
void wait_for(int descriptor) {
  pollfd wanted{descriptor, POLLOUT, 0};
  (void)::poll(&wanted, 1, -1);
}

}  // namespace

Descriptor_buffer::Descriptor_buffer(int descriptor) : bytes_(SIZE), descriptor_(descriptor) {
  setp(bytes_.data(), bytes_.data() + bytes_.size());
}

Descriptor_buffer::int_type Descriptor_buffer::overflow(int_type c) {
  if (sync() != 0) return traits_type::eof();
  if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
  return traits_type::not_eof(c);
}

std::streamsize Descriptor_buffer::xsputn(const char* bytes, std::streamsize size) {
  if (size < static_cast<std::streamsize>(SIZE)) return std::streambuf::xsputn(bytes, size);
  if (sync() != 0) return 0;
  write(bytes, bytes + size);
  return error_ == 0 ? size : 0;
}

void Descriptor_buffer::write(const char* from, const char* end) {
  while (from < end && error_ == 0) {
    const auto written = ::write(descriptor_, from, static_cast<std::size_t>(end - from));
    if (written >= 0) from += written;
    else if (errno == EAGAIN || errno == EWOULDBLOCK) wait_for(descriptor_);
    else if (errno != EINTR) error_ = errno;
  }
}

int Descriptor_buffer::sync() {
  write(pbase(), pptr());
  setp(bytes_.data(), bytes_.data() + bytes_.size());
  return error_ == 0 ? 0 : -1;
}

}  // namespace bounding_arcs_tool
