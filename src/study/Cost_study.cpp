// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Cost_study.h.

// Before Circular_kernel_2: it makes the kernel compile over fundamental number types.
#include <CGAL/Root_of_traits.h>

#include <CGAL/Algebraic_kernel_for_circles_2_2.h>
#include <CGAL/CORE_Expr.h>
#include <CGAL/Circular_kernel_2.h>
#include <CGAL/Simple_cartesian.h>

#include <CGAL/Bounding_arcs_2/number/Root_number.h>
#include <CGAL/Bounding_arcs_2/region/Bca_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Bilens_traits_2.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc_traits_2.h>
#include <CGAL/Bounding_arcs_2/study/Cost_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include "Enclosed_piece.h"
#include "least_seconds.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace study {

using Exact = CGAL::Exact_rational;
using Rational_kernel =
    CGAL::Circular_kernel_2<CGAL::Simple_cartesian<Exact>, CGAL::Algebraic_kernel_for_circles_2_2<Exact>>;

[[nodiscard]] static std::size_t length_in_bits(const Exact& x) {
  const auto* q = internal::rational_data(x);
  return (std::max)(mpz_sizeinbase(mpq_numref(q), 2), mpz_sizeinbase(mpq_denref(q), 2));
}

[[nodiscard]] static std::size_t length_in_bits(const Chord_frame_2<Exact>& frame) {
  std::size_t bits = 0;
  const auto look = [&bits](const Exact& x) {
    bits = (std::max)(bits, length_in_bits(x));
    return x;
  };
  for (const Xy<Exact>* p : {&frame.p0, &frame.p1}) look(p->x), look(p->y);
  static_cast<void>(frame.shape.over<Exact>(look));
  return bits;
}

// The longest number in the coordinates of a boundary's corners, each a + b sqrt(c).
[[nodiscard]] static std::size_t root_bits(const Kernel_boundary_2<Rational_kernel>& boundary) {
  std::size_t bits = 0;
  const auto look = [&bits](const typename Rational_kernel::Root_of_2& x) {
    for (const Exact& part : {Exact(x.a0()), Exact(x.a1()), Exact(x.root())})
      bits = (std::max)(bits, length_in_bits(part));
  };
  for (const auto* chain : {&boundary.inner, &boundary.outer})
    for (const auto& piece : *chain)
      std::visit(
          [&](const auto& curve) {
            if constexpr (std::is_same_v<std::decay_t<decltype(curve)>, Algebraic_segment_2<Rational_kernel>>) {
              for (const auto* p : {&curve.source, &curve.target}) look(p->x()), look(p->y());
            } else {
              for (const auto& p : {curve.source(), curve.target()}) look(p.x()), look(p.y());
            }
          },
          piece.curve);
  return bits;
}

// A piece with what is asked of it, made ahead so that no time goes there.
struct Costed_piece {
  const Study_piece* piece;
  Taylor_table<double> table;
  Chord_frame_2<Exact> frame;
  double thickness;  // the nearest double, or one next to it
};

// The least precision in steps of 32 bits that leaves a thickness no wider than 53 bits; 0 where none does.
template <class Thickness> [[nodiscard]] std::size_t least_precision(const Thickness& thickness) {
  constexpr mpfr_prec_t STEP = 32, FINE = 1024;
  for (mpfr_prec_t bits = 2 * STEP; bits <= LAST_PRECISION; bits += bits < FINE ? STEP : bits / 4) {
    try {
      if (thickness(bits).relative_width() <= 0x1p-53) return static_cast<std::size_t>(bits);
    } catch (const CGAL::Uncertain_conversion_exception&) {  // a comparison is open at this precision
    }
  }
  return 0;
}

// The bits of the approximation that comparisons have asked for.
[[nodiscard]] static std::size_t precision(const Root_number& x) {
  CORE::ExprRep* node = x.expression().Rep();
  return node->appComputed() ? CORE::bitLength(node->appValue().BigFloatValue().m()) : 0;
}
// A number other than 0 is at least 2^-this; so many bits have to be right before it is called 0.
[[nodiscard]] static std::size_t separation_bits(const Root_number& x) {
  static_cast<void>(x.compare(Root_number(0)));  // the bound is made of what a sign sets
  const CORE::extLong bits = x.expression().Rep()->computeBound();
  return bits.sign() > 0 ? static_cast<std::size_t>(bits.asLong()) : 0;
}

template <class Construction> [[nodiscard]] Root_number expression(const Costed_piece& c) {
  const auto shape = c.piece->spiral.template shape<Exact>(c.piece->t0, c.piece->t1);
  return Construction::thickness(shape.over<Root_number>());
}

template <class Construction> void count(const Costed_piece& piece, Stage_counts& counts) {
  const Piece_source<Bezier_spiral_2<double>> source{piece.piece->spiral, piece.piece->t0, piece.piece->t1};
  const auto decide = [&](double eps) {
    const Thickness_bound bound = bound_thickness<double, true>(Construction(), source, eps);
    if (!bound.was_exact) ++counts.bounded;
    else if (bound.bits == 0) ++counts.expression;
    else ++(bound.bits == 53 ? counts.interval : counts.enclosure);
  };
  decide(piece.thickness);
  for (int j = 8; j <= 48; j += 8)
    for (const int side : {-1, 1}) decide(piece.thickness * (1 + side * std::ldexp(1.0, -j)));
}

// Pieces on which a method's region does not step back, and whose thickness can be told.
template <class Construction>
[[nodiscard]] std::vector<Costed_piece> costed(const std::vector<Study_piece>& pieces, Region_form form) {
  std::vector<Costed_piece> found;
  for (const Study_piece& piece : pieces) {
    auto frame = piece.spiral.frame<Exact>(piece.t0, piece.t1);
    const auto rounded = piece.spiral.frame<double>(piece.t0, piece.t1);
    if ((Construction::NEEDS_CURVATURE && !frame.shape.proper) || Construction::boundary(rounded).form != form)
      continue;
    const auto thickness = thickness_enclosure(Construction(), frame.shape, LAST_PRECISION);
    if (thickness && thickness->relative_width() <= 0x1p-60)
      found.push_back({&piece, Taylor_table<double>(piece.spiral.curve(), length_unit(piece.spiral.curve())),
                       std::move(frame), thickness->middle()});
  }
  return found;
}

// The sum of figures, so that no compiler leaves them out.
template <class Work>
[[nodiscard]] double seconds(const std::vector<Costed_piece>& pieces, std::size_t repeat, std::size_t rounds,
                             const Work& work) {
  volatile double sum = 0;
  const double all = internal::least_seconds(repeat, [&] {
    for (std::size_t i = 0; i < rounds; ++i)
      for (const Costed_piece& piece : pieces) sum = sum + work(piece);
  });
  return all / static_cast<double>(rounds);
}

template <class Construction, class Textbook, class Rational_traits>
void add_cost(const std::vector<Study_piece>& pieces, Region_form form, std::size_t repeat,
              std::vector<Cost_row>& rows) {
  const std::vector<Costed_piece> costed = study::costed<Construction>(pieces, form);
  if (costed.empty()) return;
  constexpr bool IS_RATIONAL = !std::is_void_v<Rational_traits>;
  Cost_row row{pieces.front().family, pieces.front().delta, Construction::NAME, costed.size()};
  bool has_textbook_bits = true;
  for (const Costed_piece& c : costed) {
    Enclosed_piece piece(c.piece->spiral, c.piece->t0, c.piece->t1);
    row.rational_bits = (std::max)(row.rational_bits, length_in_bits(c.frame));
    row.stable_bits = (std::max)(
        row.stable_bits, least_precision([&](mpfr_prec_t bits) { return Construction::thickness(piece.shape(bits)); }));
    const std::size_t textbook =
        least_precision([&](mpfr_prec_t bits) { return Textbook::thickness(piece.frame(bits)); });
    has_textbook_bits = has_textbook_bits && textbook > 0;
    row.textbook_bits = (std::max)(row.textbook_bits, textbook);
    if constexpr (IS_RATIONAL) {
      const Rational_traits traits;
      const auto region = traits.construct_bounding_region_2_object()(c.frame);
      row.root_bits = (std::max)(row.root_bits, root_bits(traits.construct_boundary_2_object()(region)));
    }
    const Root_number thickness = expression<Construction>(c), difference = thickness - Root_number(c.thickness);
    row.separation_bits = (std::max)(row.separation_bits, separation_bits(difference));
    row.expression_bits = (std::max)(row.expression_bits, precision(thickness));
    count<Construction>(c, row.decisions);
  }
  if (!has_textbook_bits) row.textbook_bits = 0;
  constexpr std::size_t ROUNDS = 64;
  const double unit = seconds(costed, repeat, ROUNDS, [](const Costed_piece& c) {
    const auto& p = *c.piece;
    return Construction::thickness(bezier_chord_shape(c.table, p.t0, p.t1, {}, p.spiral.orders(p.t0, p.t1)));
  });
  row.stable_time =
      seconds(costed, repeat, ROUNDS,
              [](const Costed_piece& c) {
                return Construction::thickness(c.piece->spiral.template frame<double>(c.piece->t0, c.piece->t1).shape);
              }) /
      unit;
  row.bounded_time = seconds(costed, repeat, ROUNDS,
                             [](const Costed_piece& c) {
                               const auto shape =
                                   c.piece->spiral.template shape<Bounded_double>(c.piece->t0, c.piece->t1);
                               return Construction::thickness(shape).value();
                             }) /
                     unit;
  row.enclosure_time =
      seconds(costed, repeat, 1,
              [&](const Costed_piece& c) {
                Enclosed_piece piece(c.piece->spiral, c.piece->t0, c.piece->t1);
                return Construction::thickness(piece.shape(static_cast<mpfr_prec_t>(row.stable_bits))).middle();
              }) /
      unit;
  if constexpr (IS_RATIONAL)
    row.rational_time = seconds(costed, repeat, 1,
                                [](const Costed_piece& c) {
                                  const Rational_traits traits;
                                  const auto frame = c.piece->spiral.template frame<Exact>(c.piece->t0, c.piece->t1);
                                  const auto region = traits.construct_bounding_region_2_object()(frame);
                                  return static_cast<double>(traits.construct_boundary_2_object()(region).inner.size());
                                }) /
                        unit;
  row.expression_time =
      seconds(costed, repeat, 1,
              [](const Costed_piece& c) {
                return static_cast<double>(expression<Construction>(c).compare(Root_number(c.thickness)));
              }) /
      unit;
  rows.push_back(row);
}

}  // namespace study

std::vector<Cost_row> cost_rows(const std::vector<Study_piece>& pieces, std::size_t repeat) {
  using namespace study;
  std::vector<Cost_row> rows;
  add_cost<Bca, Textbook_bca, Bca_traits_2<Rational_kernel>>(pieces, Region_form::BCA, repeat, rows);
  add_cost<Spiral_fat_arc, Textbook_spiral_fat_arc, Spiral_fat_arc_traits_2<Rational_kernel>>(
      pieces, Region_form::SPIRAL_FAT_ARC, repeat, rows);
  add_cost<Bilens, Textbook_bilens, void>(pieces, Region_form::BILENS, repeat, rows);
  return rows;
}

}  // namespace CGAL::Bounding_arcs
