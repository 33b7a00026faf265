// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the compiled overlay takes of a tree.

#ifndef CGAL_BOUNDING_ARCS_2_OVERLAY_OUTLINE_OPERAND_H
#define CGAL_BOUNDING_ARCS_2_OVERLAY_OUTLINE_OPERAND_H

#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/tree/Drawing_hierarchy.h>

#include <vector>

namespace CGAL::Bounding_arcs {

/// A drawing of doubles, its hierarchy where its numbers were others, and what its curves fill.
struct Outline_operand {
  const Drawing_2<double>* drawing;
  const Drawing_hierarchy* exact = nullptr;
  Fill_rule rule = Fill_rule::NONZERO;
};

/// Returns what the overlay takes of trees. Exact numbers need the hierarchy, which has them.
/// \throws std::invalid_argument for another number of rules than of trees
template <class Tree>
[[nodiscard]] std::vector<Outline_operand> outline_operands(const std::vector<const Tree*>& trees,
                                                            const Fill_rules& rules = Fill_rule::NONZERO) {
  std::vector<Outline_operand> operands;
  operands.reserve(trees.size());
  for (const Tree* tree : trees)
    operands.push_back(
        {&tree->drawing(), tree->rounding() == 0 ? nullptr : &tree->curves(), rules.of(operands.size(), trees.size())});
  return operands;
}

}  // namespace CGAL::Bounding_arcs

#endif
