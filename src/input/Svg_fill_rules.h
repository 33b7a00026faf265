// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fill rule of a drawing, by those of its shapes.

#ifndef BOUNDING_ARCS_TOOL_SVG_FILL_RULES_H
#define BOUNDING_ARCS_TOOL_SVG_FILL_RULES_H

#include "Svg_notes.h"
#include "Svg_outline.h"

#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Fill_rule;

/// Counts closed shapes, and open ones that are filled as if they were closed, by their fill rule. A rule tells where a
/// shape has several subpaths or crosses itself, and such shapes decide. Where there are none the rule is nonzero:
/// viewers paint each shape by itself, so that a shape within another one is no hole.
class Svg_fill_rules {
 public:
  /// \param element the name of the shape's element
  /// \param are_open_filled whether its open subpaths are filled
  void add(Fill_rule rule, std::string_view element, const std::vector<Svg_subpath>& subpaths, bool are_open_filled);

  /// The rule of most shapes, nonzero for as many of each. Notes shapes that have the other rule, where it tells.
  [[nodiscard]] Fill_rule most(Svg_notes& notes) const;

 private:
  struct Count {
    std::map<std::string, std::size_t> telling;  // shapes for which the rule tells, by their names
    [[nodiscard]] std::size_t all_telling() const;
  };
  Count nonzero_, even_odd_;
};

}  // namespace bounding_arcs_tool

#endif
