// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Line_source.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Input_error;

constexpr std::size_t READ_SIZE = std::size_t(1) << 16;  // what a pipe holds

[[noreturn]] void fail(const std::string& name, const std::string& what, int cause) {
  throw Input_error(name, "file", what + ": " + std::generic_category().message(cause));
}

bool is_blank(const std::string& text) { return text.find_first_not_of(" \t\r") == std::string::npos; }

}  // namespace

Line_source::Line_source(const std::string& path)
    : name_(path == "-" ? "stdin" : path),
      descriptor_(path == "-" ? STDIN_FILENO : ::open(path.c_str(), O_RDONLY | O_CLOEXEC)), bytes_(READ_SIZE) {
  if (descriptor_ < 0) fail(name_, "cannot be opened", errno);
}

Line_source::~Line_source() {
  if (descriptor_ != STDIN_FILENO) ::close(descriptor_);
}

bool Line_source::next(Line_block& block) {
  const std::lock_guard<std::mutex> lock(mutex_);
  block.lines.clear();
  while (block.lines.empty() && !is_at_end_) {
    const std::size_t size = read_some();
    is_at_end_ = size == 0;
    if (is_at_end_) end_line(block.lines);
    else take({bytes_.data(), size}, block.lines);
  }
  if (block.lines.empty()) return false;
  block.place = blocks_++;
  records_ += block.lines.size();
  return true;
}

std::size_t Line_source::read_some() {
  for (;;) {
    const auto size = ::read(descriptor_, bytes_.data(), bytes_.size());
    if (size >= 0) return static_cast<std::size_t>(size);
    if (errno == EAGAIN || errno == EWOULDBLOCK) {  // a terminal or pipe that was set not to block
      pollfd wanted{descriptor_, POLLIN, 0};
      (void)::poll(&wanted, 1, -1);
    } else if (errno != EINTR) {
      fail(name_, "cannot be read", errno);
    }
  }
}

void Line_source::take(std::string_view text, std::vector<Line>& lines) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view part = text.substr(0, end);
    if (!line_.is_too_long) line_.text += part;
    if (line_.text.size() > LONGEST_LINE) {
      line_.is_too_long = true;
      std::string().swap(line_.text);  // gives the memory back
    }
    if (end == text.npos) return;
    end_line(lines);
    text.remove_prefix(end + 1);
  }
}

void Line_source::end_line(std::vector<Line>& lines) {
  const std::size_t number = line_.number;
  if (line_.is_too_long || !is_blank(line_.text)) lines.push_back(std::move(line_));
  line_ = Line{number + 1};
}

}  // namespace bounding_arcs_tool
