// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The entry for libFuzzer; which target it is for is said by the environment: FUZZ_TARGET.

#include "targets.h"

using namespace bounding_arcs_fuzz;

static Target target = nullptr;

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("FUZZ_TARGET");
  target = target_of(name == nullptr ? "" : name);
  if (target != nullptr) return 0;
  std::fprintf(stderr, "FUZZ_TARGET is to be one of");
  for (const auto& known : TARGETS) std::fprintf(stderr, " %s", known.first);
  std::fprintf(stderr, "\n");
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target(data, size);
  return 0;
}
