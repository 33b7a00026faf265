// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is fuzzed: each takes any bytes, and ends the program where something is wrong that is not said of the input.

#ifndef BOUNDING_ARCS_FUZZ_TARGETS_H
#define BOUNDING_ARCS_FUZZ_TARGETS_H

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace bounding_arcs_fuzz {

using Target = void (*)(const std::uint8_t* data, std::size_t size);

// Readers of files and records.
void json(const std::uint8_t* data, std::size_t size);
void svg(const std::uint8_t* data, std::size_t size);
void dxf(const std::uint8_t* data, std::size_t size);
void stream(const std::uint8_t* data, std::size_t size);
// Curves decoded from bytes, see Byte_source.h.
void build(const std::uint8_t* data, std::size_t size);
void arcs(const std::uint8_t* data, std::size_t size);
void query(const std::uint8_t* data, std::size_t size);
void offset(const std::uint8_t* data, std::size_t size);
void medial_axis(const std::uint8_t* data, std::size_t size);

inline constexpr std::pair<const char*, Target> TARGETS[] = {
    {"json", json}, {"svg", svg},     {"dxf", dxf},       {"stream", stream},           {"build", build},
    {"arcs", arcs}, {"query", query}, {"offset", offset}, {"medial_axis", medial_axis},
};

/// \return nullptr where there is none of that name
inline Target target_of(std::string_view name) {
  for (const auto& [known, target] : TARGETS)
    if (name == known) return target;
  return nullptr;
}

/// Ends the program unless what is claimed of a result holds.
inline void expect(bool holds, const char* claim) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", claim);
  std::abort();
}

/// Does work that may refuse its input, as the library does.
template <class Work> void attempt(const Work& work) {
  try {
    work();
  } catch (const std::invalid_argument&) {
  }
}

}  // namespace bounding_arcs_fuzz

#endif
