// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The internal subset of a document type declaration: what the entities of an XML document stand for.

#ifndef BOUNDING_ARCS_TOOL_XML_DOCTYPE_H
#define BOUNDING_ARCS_TOOL_XML_DOCTYPE_H

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>

namespace bounding_arcs_tool {

/// The entities that an XML document declares for its contents.
struct Xml_doctype {
  std::size_t end = 0;  ///< where the declaration ends in the text; where it would start, if there is none
  std::unordered_map<std::string_view, std::string> entities;  ///< by name: their text, still with references
  std::unordered_set<std::string_view> external;               ///< names of those that stand in other files
};

/// Reads the declaration, as far as it is well-formed; the text must outlive the result. Entities of the declaration
/// itself, with a per cent sign, play no part.
[[nodiscard]] Xml_doctype parsed_xml_doctype(std::string_view text);

/// The length of the XML name at the start of a text.
[[nodiscard]] std::size_t xml_name_length(std::string_view text);

}  // namespace bounding_arcs_tool

#endif
