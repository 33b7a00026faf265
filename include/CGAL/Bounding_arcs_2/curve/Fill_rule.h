// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which points closed curves have inside.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_FILL_RULE_H
#define CGAL_BOUNDING_ARCS_2_CURVE_FILL_RULE_H

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// The rule says which points are inside. NONZERO takes those that curves run round other than 0 times,
/// counterclockwise less clockwise; EVEN_ODD those that they run round an odd number of times.
enum class Fill_rule : std::uint8_t { NONZERO, EVEN_ODD };

/// Whether points that curves run round so often are inside.
[[nodiscard]] inline bool is_filled(Fill_rule rule, int winding) {
  return rule == Fill_rule::NONZERO ? winding != 0 : winding % 2 != 0;
}

/// What the curves of several drawings fill: one rule for all of them, or one for each.
/// \code
/// unite(tree, other, Fill_rule::EVEN_ODD);
/// difference(tree, other, {Fill_rule::NONZERO, Fill_rule::EVEN_ODD});
/// \endcode
class Fill_rules {
 public:
  Fill_rules(Fill_rule all) : rules_{all}, is_of_all_(true) {}  // NOLINT: one rule is all rules
  Fill_rules(std::initializer_list<Fill_rule> rules) : rules_(rules) {}
  explicit Fill_rules(std::vector<Fill_rule> rules) : rules_(std::move(rules)) {}

  /// \throws std::invalid_argument where there are fewer or more rules than drawings
  [[nodiscard]] Fill_rule of(std::size_t drawing, std::size_t drawings) const {
    if (is_of_all_) return rules_.front();
    if (rules_.size() != drawings)
      throw std::invalid_argument(expected("fill rules", "one for each drawing, or one for all",
                                           std::to_string(rules_.size()) + " for " + std::to_string(drawings)));
    return rules_[drawing];
  }

 private:
  std::vector<Fill_rule> rules_;
  bool is_of_all_ = false;
};

}  // namespace CGAL::Bounding_arcs

#endif
