// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs targets on files once: past findings, and seeds. The first part of a file's name is its target, as in
// svg-deep_groups.
// Usage: replay_fuzz FILES

#include "targets.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

int main(int count, char** arguments) {
  for (int i = 1; i < count; ++i) {
    const std::string name = std::filesystem::path(arguments[i]).filename().string();
    const auto target = bounding_arcs_fuzz::target_of(name.substr(0, name.find('-')));
    std::ifstream file(arguments[i], std::ios::binary);
    if (target == nullptr || !file) {
      std::fprintf(stderr, "%s: no target, or no file\n", arguments[i]);
      return 2;
    }
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    std::printf("%s\n", name.c_str());
    std::fflush(stdout);
    target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  return count > 1 ? 0 : 2;
}
