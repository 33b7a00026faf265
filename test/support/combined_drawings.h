// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two drawings combined by the public function, and faults that name them as files for the tool.

#ifndef BOUNDING_ARCS_TEST_COMBINED_DRAWINGS_H
#define BOUNDING_ARCS_TEST_COMBINED_DRAWINGS_H

#include "faults.h"
#include "longest_call.h"
#include "nudged_drawings.h"
#include "outline_checks.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>

#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounding_arcs_test {

/// An operation, and what the curves of either operand fill.
struct Operation {
  Boolean_operation operation = Boolean_operation::UNION;
  Fill_rule rule_a = Fill_rule::NONZERO, rule_b = Fill_rule::NONZERO;

  [[nodiscard]] bool is_filled(int winding_a, int winding_b) const {
    const bool a = ba::is_filled(rule_a, winding_a), b = ba::is_filled(rule_b, winding_b);
    switch (operation) {
      case Boolean_operation::UNION:
        return a || b;
      case Boolean_operation::INTERSECTION:
        return a && b;
      case Boolean_operation::DIFFERENCE:
        return a && !b;
      case Boolean_operation::SYMMETRIC_DIFFERENCE:
        return a != b;
    }
    return false;
  }
};

template <class Tree> Outline_2 outline_of(const Tree& a, const Tree& b, const Operation& how) {
  return ba::boolean_operation({&a, &b}, how.operation, {how.rule_a, how.rule_b});
}

inline Operation random_operation(std::mt19937& random) {
  constexpr Boolean_operation OPERATIONS[] = {Boolean_operation::UNION, Boolean_operation::INTERSECTION,
                                              Boolean_operation::DIFFERENCE, Boolean_operation::SYMMETRIC_DIFFERENCE};
  const auto rule = [&] { return one_in(random, 2) ? Fill_rule::NONZERO : Fill_rule::EVEN_ODD; };
  Operation how;
  how.operation = one_of(random, OPERATIONS);
  how.rule_a = rule();
  how.rule_b = rule();
  return how;
}

inline std::string words_of(const Operation& how) {
  constexpr const char* OPERATIONS[] = {"union", "intersection", "difference", "symmetric-difference"};
  const auto word = [](Fill_rule rule) { return rule == Fill_rule::NONZERO ? "nonzero" : "evenodd"; };
  std::string text = OPERATIONS[static_cast<std::size_t>(how.operation)];
  text += std::string(" --rule ") + word(how.rule_a);
  return how.rule_b == how.rule_a ? text : text + " and " + word(how.rule_b);
}
/// A fault with the operands that have it, as files for the tool.
struct Told_fault : std::runtime_error {
  Told_fault(const std::string& what, const std::string& how, const Drawing& a, const Drawing& b)
      : std::runtime_error(what + '\n' + how + '\n' + json_text(a) + '\n' + json_text(b)) {}
};
/// Calls what may throw a fault, or anything.
template <class Function>
auto told(const std::string& how, const Drawing& a, const Drawing& b, const Function& function) {
  try {
    return function();
  } catch (const Told_fault&) {
    throw;
  } catch (const Fault& e) {
    throw Told_fault(e.what(), how, a, b);
  } catch (const std::exception& e) {
    throw Told_fault(std::string("exception: ") + e.what(), how, a, b);
  }
}

/// What an operation makes, with its rounded curves, and what a user goes on with.
struct Combined {
  Outline_2 outline;
  Drawing rounded;   // curve i is chain i
  double moved = 0;  // by how much that is off
  ba::Outline_2::Drawn drawn;
};
template <class Tree> Combined combined(const Drawing& a, const Drawing& b, const Operation& how) {
  return told(words_of(how), a, b, [&] {
    using FT = typename Tree::FT;
    return timed([&] {
      const Tree tree_a(a.over<FT>()), tree_b(b.over<FT>());
      Combined made{outline_of(tree_a, tree_b, how), {}, 0, {}};
      if (made.outline.status == ba::Outline_2::Status::UNDECIDED) throw Fault("undecided", "no outline");
      if (made.outline.status != ba::Outline_2::Status::COMPLETE) throw Fault("incomplete", "another status");
      made.rounded = ba::drawn_outline({&tree_a, &tree_b}, made.outline, {false}).drawing;
      made.moved = ba::drawn_outline({&tree_a, &tree_b}, made.outline, {false}).moved;
      made.drawn = ba::drawn_outline({&tree_a, &tree_b}, made.outline);
      return made;
    });
  });
}

}  // namespace bounding_arcs_test

#endif
