// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In place of the writer of DXF files where dxflib was not found.

#include "write_dxf.h"

#include <stdexcept>

namespace bounding_arcs_tool {

void write_dxf(std::ostream&, const Written_drawing&, Dxf_entities) {
  throw std::runtime_error("--format: expected a form without DXF, as the tool was built without dxflib, found dxf");
}

}  // namespace bounding_arcs_tool
