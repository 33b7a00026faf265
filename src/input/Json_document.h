// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON text as a document, with the place of what is wrong with it.

#ifndef BOUNDING_ARCS_TOOL_JSON_DOCUMENT_H
#define BOUNDING_ARCS_TOOL_JSON_DOCUMENT_H

#include <nlohmann/json.hpp>

#include <string>

namespace bounding_arcs_tool {

/// The document that a JSON text holds.
/// \param file what errors call the file
/// \throws Input_error for a syntax error (place: line and column), and for a number beyond double, a key that appears
///   twice in an object, or nesting deeper than 64 levels (place: the path, such as curves[2].degree)
[[nodiscard]] nlohmann::json parsed_json(const std::string& text, const std::string& file);

}  // namespace bounding_arcs_tool

#endif
