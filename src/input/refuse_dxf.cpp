// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// In place of the reader of DXF files where dxflib was not found.

#include "Curve_readers.h"

namespace bounding_arcs_tool {

Curve_file read_dxf_curves(const std::string&, const std::string& file, const Reading_options&) {
  throw Input_error(file, "file", "is DXF, and this library was built without dxflib");
}

}  // namespace bounding_arcs_tool
