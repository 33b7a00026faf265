// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The library's isolation of real roots beside that of CGAL's Algebraic_kernel_d_1: from integer coefficients to the
// doubles around all roots in [0,1]. CGAL's numbers are CORE's, as GMP's have no bigfloat intervals there.

#include "../../src/library/polynomial/Real_root.h"

#include <CGAL/Algebraic_kernel_d_1.h>
#include <CGAL/CORE_arithmetic_kernel.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iterator>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;
using Core_integer = CORE::BigInt;
using Core_polynomial = CGAL::Polynomial<Core_integer>;
using Algebraic_kernel = CGAL::Algebraic_kernel_d_1<Core_integer>;

/// Random polynomials, whose coefficients in Bernstein's form have so many bits.
std::vector<ba::Univariate> random_polynomials(std::size_t count, int degree, int bits) {
  std::mt19937_64 random(7);
  std::vector<ba::Univariate> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<ba::Integer> scaled;
    for (int k = 0; k <= degree; ++k) {
      ba::Integer c(0);
      constexpr int PART = 30;
      for (int b = 0; b < bits; b += PART) c = (c << PART) + ba::Integer(static_cast<int>(random() >> (64 - PART)));
      scaled.push_back(random() % 2 == 0 ? c : ba::Integer(-c));
    }
    result.push_back(ba::to_powers(scaled));
  }
  return result;
}

Core_polynomial converted(const ba::Univariate& p) {
  std::vector<Core_integer> c;
  for (int i = 0; i <= p.degree(); ++i) {
    std::ostringstream digits;
    digits << ba::coefficient(p, i);
    c.emplace_back(digits.str().c_str());
  }
  return {c.begin(), c.end()};
}

struct Timed {
  double microseconds = HUGE_VAL;  ///< a polynomial, the least of three runs
  std::size_t roots = 0;
};
template <class P, class Roots> Timed timed(const std::vector<P>& polynomials, const Roots& roots) {
  Timed best;
  for (int run = 0; run < 3; ++run) {
    const std::clock_t start = std::clock();
    best.roots = 0;
    for (const P& p : polynomials) best.roots += roots(p);
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    best.microseconds = (std::min)(best.microseconds, 1e6 * seconds / static_cast<double>(polynomials.size()));
  }
  return best;
}

}  // namespace

int main() {
  struct Kind {
    int degree, bits;
  };
  const Algebraic_kernel kernel;
  std::puts("degree  bits  roots  us    ratio of Algebraic_kernel_d_1");
  for (const Kind& kind : {Kind{3, 60}, Kind{4, 120}, Kind{5, 60}, Kind{9, 500}, Kind{12, 300}, Kind{25, 800}}) {
    const auto polynomials = random_polynomials(200, kind.degree, kind.bits);
    std::vector<Core_polynomial> theirs;
    for (const ba::Univariate& p : polynomials) theirs.push_back(converted(p));
    const Timed own = timed(polynomials, [](const ba::Univariate& p) {
      auto roots = ba::unit_roots(p);
      for (ba::Real_root& t : roots) (void)t.range();
      return roots.size();
    });
    const Timed other = timed(theirs, [&](const Core_polynomial& p) {
      std::vector<std::pair<Algebraic_kernel::Algebraic_real_1, int>> roots;
      kernel.solve_1_object()(p, Algebraic_kernel::Bound(0), Algebraic_kernel::Bound(1), std::back_inserter(roots));
      for (const auto& t : roots) (void)CGAL::to_interval(t.first);
      return roots.size();
    });
    std::printf("%6d %5d %6zu %5.0f %6.1f\n", kind.degree, kind.bits, own.roots, own.microseconds,
                other.microseconds / own.microseconds);
    if (own.roots != other.roots) return EXIT_FAILURE;
  }
}
