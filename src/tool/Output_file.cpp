// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_file.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Input_error;

namespace {

// The descriptor that a path stands for: what the shell has opened there is written on, not replaced.
std::optional<int> named_descriptor(std::string_view path) {
  if (path.empty() || path == "-" || path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (path.substr(0, folder.size()) != folder) continue;
    int descriptor = -1;
    const char* const end = path.data() + path.size();
    const auto [last, status] = std::from_chars(path.data() + folder.size(), end, descriptor);
    if (status == std::errc() && last == end && descriptor >= 0) return descriptor;
  }
  return std::nullopt;
}

// Where the last part of a path leads to, also if there is nothing yet.
std::string followed(const std::string& path) {
  constexpr int MOST_LINKS = 40;  // as Linux has it
  std::filesystem::path place = path;
  std::error_code error;
  for (int i = 0; i < MOST_LINKS; ++i) {
    const auto target = std::filesystem::read_symlink(place, error);
    if (error) break;
    place = place.parent_path() / target;
  }
  return place.string();
}

}  // namespace

Output_file::Output_file(const std::string& path) : path_(path) {
  buffer_.emplace(opened(path));
  stream_.emplace(&*buffer_);
}

Output_file::~Output_file() {
  if (in_place_ >= 0) ::close(in_place_);
}

// The descriptor to write to.
int Output_file::opened(const std::string& path) {
  constexpr mode_t ANY_MAY_WRITE = 0222;
  if (const auto descriptor = named_descriptor(path)) return *descriptor;
  struct stat old {};
  if (::stat(path.c_str(), &old) != 0) {
    if (errno != ENOENT) fail(errno);
    return opened_beside(path, nullptr);
  }
  if (S_ISDIR(old.st_mode)) throw Input_error(path, "cannot write", "expected a file, found a directory");
  // The superuser may write anything. Who took away all permissions did not mean that.
  if ((old.st_mode & ANY_MAY_WRITE) == 0)
    throw Input_error(path, "cannot write", "expected a file that may be written, found a read-only one");
  // Replacing a file needs no right to write it, only to write in its folder.
  if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);
  if (S_ISREG(old.st_mode)) return opened_beside(path, &old);
  in_place_ = ::open(path.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
  if (in_place_ < 0) fail(errno);
  return in_place_;
}

// Whether a folder may be written is left to the system: there are systems where the superuser's own has no such bit.
int Output_file::opened_beside(const std::string& path, const struct stat* old) {
  const std::filesystem::path target = followed(path);
  name_ = target.filename().string();
  if (name_.empty()) fail(EISDIR);
  const std::string folder = target.parent_path().string();
  unfinished_ = std::make_unique<Unfinished_file>(folder.empty() ? "." : folder, old);
  if (unfinished_->descriptor() < 0) fail(errno);
  return unfinished_->descriptor();
}

void Output_file::commit() {
  stream_->flush();
  if (!*stream_) fail(buffer_->error());
  if (in_place_ >= 0 && ::close(std::exchange(in_place_, -1)) != 0) fail(errno);
  if (unfinished_ && !unfinished_->rename_to(name_)) fail(errno);
}

void Output_file::fail(int cause) const {
  const bool is_standard = path_.empty() || path_ == "-";
  throw Input_error(is_standard ? "standard output" : path_, "cannot write", std::generic_category().message(cause));
}

}  // namespace bounding_arcs_tool
