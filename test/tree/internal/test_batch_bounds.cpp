// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What batches say of a piece's thickness against the exact one, and the figures behind it against exact figures.

#include "../../../src/library/spiral/make_local_curve.h"
#include "../../../src/library/tree/Instruction_sets.h"
#include "../../../src/library/tree/batch/Bca_batch.h"
#include "../../../src/library/tree/batch/Bilens_batch.h"
#include "../../../src/library/tree/batch/Piece_decisions.h"
#include "../../../src/library/tree/batch/Spiral_fat_arc_batch.h"
#include "../../../src/library/tree/batch/bound_batch.h"
#include "batch_families.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace test_batch_bounds {
namespace {

using namespace CGAL::Bounding_arcs;
using namespace bounding_arcs_test;
using Bounds = CGAL::Bounding_arcs::Bracket;

constexpr unsigned SEED = 601;
constexpr mpfr_prec_t PRECISION = 2048;

template <class Construction> Mpfr_interval exact_thickness(const Piece& piece) {
  const auto shape = piece.spiral.shape<Exact>(piece.t0, piece.t1, {Construction::NEEDS_CURVATURE, false});
  return Construction().thickness(
      shape.template over<Mpfr_interval>([](const Exact& x) { return Mpfr_interval(x, PRECISION); }));
}

enum class Form { NARROW, WIDE, ROUGH };
constexpr Form ALL_FORMS[] = {Form::NARROW, Form::WIDE, Form::ROUGH};

// The bounds of one form of one piece.
template <class Method, int KIND> Bounds bounds_of_kind(const Piece& piece, Form form) {
  const Local_curve& curve = piece.spiral.local_curve();
  if (form == Form::ROUGH) {
    Local_form<float> rough;
    float lower[filter::GROUP<float>], upper[filter::GROUP<float>];
    const filter::Batch_pieces pieces{1, nullptr, nullptr, piece.t0, piece.t1 - piece.t0, piece.t1, 0};
    if (!filter::make_rough_form(curve, rough) || !pieces.may_be_rough()) return {-1.0, HUGE_VAL};
    filter::bound_roughly<Base_set, Method, KIND>(curve, rough, pieces, 1, lower, upper);
    const double unit = curve.form.unit * Method::rough_unit(0.5 * pieces.step);
    return {lower[0] < 0 ? -1.0 : lower[0] * (1 - Method::ROUGH_ERROR) * unit,
            upper[0] * (1 + Method::ROUGH_ERROR) * unit};
  }
  double begins[8], ends[8], lower[8], upper[8];
  std::fill_n(begins, 8, piece.t0);
  std::fill_n(ends, 8, piece.t1);
  if (form == Form::WIDE) filter::bound_all<Base_set, Method, KIND, true>(curve, begins, ends, 1, lower, upper);
  else filter::bound_all<Base_set, Method, KIND, false>(curve, begins, ends, 1, lower, upper);
  return {lower[0], upper[0]};
}
template <class Construction> Bounds bounds(const Piece& piece, Form form) {
  using Method = typename filter::Formulas<Construction>::Type;
  return for_kind(piece.spiral.local_curve().kind(),
                  [&](auto kind) { return bounds_of_kind<Method, kind()>(piece, form); });
}

struct Counts {
  int all = 0, held = 0, lower = 0, tight = 0;  // pieces; those with an upper bound, with a lower one, with near ones
};

// Holds the bounds of one form against the exact thickness.
template <class Construction> Counts expect_held(Family family, Form form) {
  const double tight = form == Form::ROUGH ? 0.05 : 1e-8;
  Counts counts;
  for (const Piece& piece : batch_pieces(family, SEED)) {
    ++counts.all;
    const Bounds b = bounds<Construction>(piece, form);
    const bool has_lower = b.lower > 0, has_upper = b.upper < HUGE_VAL;
    if (!has_lower && !has_upper) continue;
    counts.held += has_upper;
    counts.lower += has_lower;
    const Mpfr_interval thickness = exact_thickness<Construction>(piece);
    if (has_lower) {
      EXPECT_GT((thickness - Mpfr_interval(Exact(b.lower), PRECISION)).certain_sign(), 0)
          << text(piece) << " above " << b.lower;
    }
    if (has_upper) {
      EXPECT_GT((Mpfr_interval(Exact(b.upper), PRECISION) - thickness).certain_sign(), 0)
          << text(piece) << " below " << b.upper;
    }
    if (b.upper - b.lower <= 2 * tight * b.lower) ++counts.tight;
  }
  return counts;
}

template <class Construction> class Batch_bounds_of : public testing::Test {};
using Constructions = testing::Types<Bca, Bilens, Spiral_fat_arc>;
TYPED_TEST_SUITE(Batch_bounds_of, Constructions);

TYPED_TEST(Batch_bounds_of, NarrowPiecesHoldTheExactThickness) {
  for (const Family family : ALL_FAMILIES) {
    SCOPED_TRACE(name(family));
    const Counts counts = expect_held<TypeParam>(family, Form::NARROW);
    EXPECT_GT(counts.held, counts.all / 2);
    EXPECT_GT(counts.lower, counts.all / 2);
    // next to a vertex numerator and kneser are differences of nearly equal numbers
    if (family != Family::NEAR_VERTEX && family != Family::NEAR_CIRCULAR) {
      EXPECT_GT(counts.tight, counts.held / 10 * 9);
    }
  }
}

TYPED_TEST(Batch_bounds_of, WidePiecesHoldTheExactThickness) {
  for (const Family family : ALL_FAMILIES) {
    SCOPED_TRACE(name(family));
    const Counts counts = expect_held<TypeParam>(family, Form::WIDE);
    // the wide BCA gives up on short pieces
    const int least = TypeParam::NEEDS_CURVATURE ? counts.all / 4 * 3 : counts.all / 20;
    EXPECT_GT(counts.held, least);
    EXPECT_GT(counts.lower, least);
  }
}

TYPED_TEST(Batch_bounds_of, RoughBoundsHoldTheExactThickness) {
  for (const Family family : ALL_FAMILIES) {
    SCOPED_TRACE(name(family));
    const Counts counts = expect_held<TypeParam>(family, Form::ROUGH);
    const int least = counts.all / 20;  // float serves few of the nearly linear ones
    EXPECT_GT(counts.held, least);
    EXPECT_GT(counts.lower, least);
    if (family == Family::PLAIN || family == Family::TINY || family == Family::HUGE_UNITS) {
      EXPECT_GT(counts.tight, counts.held / 2);
    }
  }
}

// A sliver of two ulps across the tip of a fold, of another form than its neighbours.
TEST(SpiralFatArcBounds, LeaveOutPiecesWhoseCirclesAreNotNested) {
  const Bezier fold({{-0.8553121567255475, 3.5820111715333371e-08},
                     {0.61394314297132779, -5.1359703359601173e-08},
                     {-0.78968928479831457, 7.4401681415563669e-08},
                     {-0.0404535093700924, 2.9449977986253223e-08}});
  int found = 0;
  for (const Spiral& spiral : spiral_segments(fold)) {
    const Piece piece{spiral, 0.75715681773316501, 0.75715681773316523};
    if (spiral.first() > piece.t0 || piece.t1 > spiral.last()) continue;
    ++found;
    const Mpfr_interval thickness = exact_thickness<Spiral_fat_arc>(piece);
    for (const Form form : ALL_FORMS) {
      const Bounds b = bounds<Spiral_fat_arc>(piece, form);
      EXPECT_GT((thickness - Mpfr_interval(Exact(b.lower), PRECISION)).certain_sign(), 0) << b.lower;
      if (b.upper < HUGE_VAL) {
        EXPECT_GT((Mpfr_interval(Exact(b.upper), PRECISION) - thickness).certain_sign(), 0) << b.upper;
      }
    }
  }
  EXPECT_EQ(found, 1);
}

// Error bounds that are made ahead for all pieces of a segment, against the exact figures of some. Shapes have vectors
// longer by h = 2 s, the length of the piece.
template <int KIND, class Real>
void expect_figures_within_bounds(const Piece& piece, const Local_form<Real>& c, Real tau, Real half) {
  constexpr Real DIGITS = Local_precision<Real>::DIGITS;
  const auto f = local_piece<KIND>(c.coefficients, tau, half);
  const auto e = local_ends<KIND>(c.coefficients, tau, f);
  // a batch may see the curve reversed and mirrored
  auto x = piece.spiral.shape<Exact>(piece.t0, piece.t1, {true, false});
  const bool is_reversed = Local_curve(piece.spiral.local_curve()).direction < 0,
             turns_otherwise = CGAL::sign(Exact(x.cross0 + x.cross1)) != CGAL::sign(f.a);
  if (is_reversed) {
    std::swap(x.tangent0, x.tangent1);
    std::swap(x.cross0, x.cross1);
    std::swap(x.curvature0, x.curvature1);
    std::swap(x.kneser0, x.kneser1);
  }
  for (Exact* number : {&x.cross0, &x.cross1, &x.curvature0, &x.curvature1})
    if (turns_otherwise) *number = -*number;
  for (Exact* number : {&x.kneser0, &x.kneser1, &x.sine_change})
    if (turns_otherwise != is_reversed) *number = -*number;
  // of rational curves the batch has other lengths, see Rational_figures.h
  const auto weight = [&](double t) {
    std::vector<Exact> w(piece.spiral.curve().weights().begin(), piece.spiral.curve().weights().end());
    for (; w.size() > 1; w.pop_back())
      for (std::size_t i = 0; i + 1 < w.size(); ++i) w[i] = (Exact(1) - Exact(t)) * w[i] + Exact(t) * w[i + 1];
    return w.empty() ? Exact(1) : w[0];
  };
  const Exact of_chord = Exact(x.unit / Exact(Local_curve(piece.spiral.local_curve()).form.unit)),
              of_tangents = Exact(of_chord * (1 + weight(piece.t1) / weight(piece.t0)) / 2);
  x.chord = of_chord * x.chord;
  x.tangent0 = of_tangents * x.tangent0;
  x.tangent1 = of_tangents * x.tangent1;
  x.sine_change = x.sine_change * of_tangents * of_tangents * of_chord * of_chord;
  for (Exact* number : {&x.cross0, &x.cross1}) *number = *number * of_tangents * of_chord;
  for (Exact* number : {&x.curvature0, &x.curvature1})
    *number = *number * of_tangents * of_tangents * of_tangents / of_chord;
  for (Exact* number : {&x.kneser0, &x.kneser1}) *number = *number * of_tangents * of_tangents * of_tangents * of_chord;
  const Exact h = Exact(piece.t1) - Exact(piece.t0), hh = Exact(h * h), h4 = Exact(hh * hh),
              third = Exact(h4 * hh / Exact(4));
  const auto expect_near = [&](Real value, const Exact& exact, Real bound, const char* what) {
    const Exact difference = Exact(Exact(static_cast<double>(value)) - exact);
    EXPECT_LE(CGAL::abs(difference), Exact(static_cast<double>(bound))) << what << ' ' << text(piece);
  };
  expect_near(f.a * f.r + f.d * f.p, Exact(x.sine_change / third / Exact(2)), c.numerator_error, "numerator");
  expect_near(e.kneser0, Exact(x.kneser0 / third), c.kneser_error, "kneser0");
  expect_near(e.kneser1, Exact(x.kneser1 / third), c.kneser_error, "kneser1");
  expect_near(e.turn_rate0, Exact(Exact(2) * x.curvature0 / (hh * h)), c.turn_rate_error, "turn_rate0");
  expect_near(e.turn_rate1, Exact(Exact(2) * x.curvature1 / (hh * h)), c.turn_rate_error, "turn_rate1");
  expect_near(f.a, Exact((x.cross0 + x.cross1) / (hh * h)), c.turn_rate_error, "a");
  expect_near(f.p - half * f.r, Exact(dot(x.tangent0, x.chord) / hh), c.least_dot / DIGITS, "T0.D");
  expect_near(f.p + half * f.r, Exact(dot(x.tangent1, x.chord) / hh), c.least_dot / DIGITS, "T1.D");
  expect_near(half * f.a, Exact((x.cross0 + x.cross1) / (hh + hh)), c.least_dot / DIGITS, "a s");
  expect_near(f.square * f.d, Exact((x.cross0 - x.cross1) / (hh + hh)), c.least_dot / DIGITS, "d s^2");
  expect_near(f.chord_square, Exact(dot(x.chord, x.chord) / hh), c.least_square / DIGITS, "M.M");
  expect_near(e.square0, Exact(dot(x.tangent0, x.tangent0) / hh), c.least_tangent / DIGITS, "|T0|^2");
  expect_near(e.square1, Exact(dot(x.tangent1, x.tangent1) / hh), c.least_tangent / DIGITS, "|T1|^2");
}
// Returns whether figures in float were checked, too.
template <int KIND> bool expect_figures_within_bounds(const Piece& piece) {
  const Local_curve& c = piece.spiral.local_curve();
  const double step = piece.t1 - piece.t0, half = 0.5 * step;
  expect_figures_within_bounds<KIND>(piece, c.form, c.direction * ((piece.t0 - c.middle) + half), half);
  Local_form<float> rough;
  const filter::Batch_pieces pieces{1, nullptr, nullptr, piece.t0, step, piece.t1, 0};
  if (!filter::make_rough_form(c, rough) || !pieces.may_be_rough()) return false;
  const auto rough_step = static_cast<float>(c.direction * step),
             offset = static_cast<float>(c.direction * (piece.t0 - c.middle));
  expect_figures_within_bounds<KIND>(piece, rough, 0.5f * rough_step + offset, static_cast<float>(half));
  return true;
}

// least_dot stands for the errors of a dot and, in all, of the two terms of the cross beside it.
template <int KIND> void expect_crosses_counted(const Local_curve& c) {
  constexpr double PLACE_ERROR = 8, LENGTH_ERROR = 2;  // as make_local_curve.h has them, in half ulps
  const auto rounded = [](double x) { return Magnitude(std::fabs(x), std::fabs(x)); };
  const Magnitude s(c.half, LENGTH_ERROR * c.half), tau(c.half, PLACE_ERROR * c.half);
  Local_coefficients<Magnitude> magnitudes;
  convert_coefficients(c.form.coefficients, KIND, rounded, magnitudes);
  const auto f = local_piece<KIND>(magnitudes, tau, s);
  EXPECT_GE(c.form.least_dot / Local_precision<double>::DIGITS,
            (f.p + s * f.r).bound() + (s * f.a).bound() + (f.square * f.d).bound());
}

TEST(BatchCurve, BoundsTheErrorsOfAllFigures) {
  for (const Family family : ALL_FAMILIES) {
    SCOPED_TRACE(name(family));
    std::map<int, int> of_kind;
    int all = 0, rough = 0;
    for (const Piece& piece : batch_pieces(family, SEED + 1)) {
      if (!(piece.t0 < piece.t1)) continue;
      const int kind = piece.spiral.local_curve().kind();
      ASSERT_NE(kind, 0);
      ++of_kind[kind];
      ++all;
      rough += for_kind(kind, [&](auto k) {
        if constexpr (k() <= 5) expect_crosses_counted<k()>(piece.spiral.local_curve());
        return expect_figures_within_bounds<k()>(piece) ? 1 : 0;
      });
    }
    EXPECT_GT(all, 200);
    EXPECT_GT(rough, all / 8);
    for (const int kind : kinds(family)) EXPECT_GT(of_kind[kind], all / 40) << kind;
  }
}

// Products of tiny lengths must not be formed before what is divided out of them.
TEST(BcaThickness, KeepsItsDigitsInTinyUnits) {
  int checked = 0;
  for (const Piece& piece : batch_pieces(Family::PLAIN, SEED + 4, 200)) {
    std::vector<Point> points = piece.spiral.curve().control_points();
    for (Point& p : points) p = {std::ldexp(p.x, -900), std::ldexp(p.y, -900)};
    const double t0 = piece.t0, t1 = piece.t1,
                 thickness = Bca().thickness(piece.spiral.accurate_shape(t0, t1, {false, false}));
    for (const Spiral& tiny : spiral_segments(Bezier(points)))
      if (tiny.first() <= t0 && t1 <= tiny.last() && thickness > 0x1p-100) {
        ++checked;
        EXPECT_EQ(Bca().thickness(tiny.accurate_shape(t0, t1, {false, false})), std::ldexp(thickness, -900))
            << text(piece);
      }
  }
  EXPECT_GT(checked, 100);
}

}  // namespace
}  // namespace test_batch_bounds
