// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files in page/, as CMake puts them into the tool.

#ifndef BOUNDING_ARCS_TOOL_REPORT_PAGE_PARTS_H
#define BOUNDING_ARCS_TOOL_REPORT_PAGE_PARTS_H

#include <string_view>

namespace bounding_arcs_tool::page_parts {

extern const std::string_view HEAD, STYLE, BODY, SCRIPT;

}  // namespace bounding_arcs_tool::page_parts

#endif
