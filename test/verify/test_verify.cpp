// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs: intervals and signs that they rest on, regions that are proven, and wrong ones that are not.

#include "../../src/library/verify/Thickness_proof.h"
#include "../../src/library/verify/prove_bca.h"
#include "Sagitta.h"
#include "cases.h"

#include <CGAL/Bounding_arcs_2.h>
#include <CGAL/Bounding_arcs_2/study/boxes_and_hulls.h>
#include <CGAL/Bounding_arcs_2/verify/verify_region.h>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace test_verify {
namespace {

using namespace CGAL::Bounding_arcs;
using verify::Integer;
using verify::Proof;
using verify::Rational;

constexpr unsigned SEED = 20261121;

Bezier_curve_2<double> random_curve(std::mt19937& random, int degree, bool rational) {
  std::uniform_real_distribution<double> coordinate(-1, 1), exponent(-2, 2);
  std::vector<Xy<double>> points;
  std::vector<double> weights;
  for (int i = 0; i <= degree; ++i) {
    points.push_back({coordinate(random), coordinate(random)});
    if (rational) weights.push_back(std::exp2(exponent(random)));
  }
  return Bezier_curve_2<double>(points, weights);
}

bool is_proven(const Region_proof& proof) { return proof.holds(); }

// Every region of the binary subdivision of every spiral down to `levels`.
template <class Construction, class Visit>
void for_each_piece(const Bezier_curve_2<double>& curve, int levels, const Visit& visit) {
  for (const auto& spiral : spiral_segments(curve))
    for (int level = 0; level <= levels; ++level) {
      const double h = (spiral.last() - spiral.first()) / (1 << level);
      int before = -1;
      for (const int i : {0, (1 << level) / 2, (1 << level) - 1}) {
        if (i == before) continue;  // of the first levels there are fewer
        before = i;
        const double t0 = i == 0 ? spiral.first() : spiral.first() + i * h;
        const double t1 = i + 1 == 1 << level ? spiral.last() : t0 + h;
        visit(spiral, t0, t1);
      }
    }
}

// Constructions that are a little wrong, which a proof must notice: one joint's contact circle is off by 2^-20
// of its curvature, one way or the other.
template <int Direction> struct Bent_bilens : Bilens {
  template <class NT> static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    Region_boundary_2<NT> b = Bilens::boundary(frame);
    if (b.form != Region_form::BILENS) return b;
    const bool first = frame.shape.tight_first;
    const auto bent = [](Boundary_piece_2<NT> piece) {
      piece.support.curvature = piece.support.curvature + NT(Direction) * piece.support.curvature / NT(1 << 20);
      return piece;
    };
    const Boundary_chain_2<NT> outer =
        first ? Boundary_chain_2<NT>(bent(b.outer[0]), b.outer[1]) : Boundary_chain_2<NT>(b.outer[0], bent(b.outer[1]));
    return {b.inner, outer, b.form};
  }
};

TEST(MpfrInterval, EnclosesResultsOfEveryOperation) {
  std::mt19937 random(SEED);
  std::uniform_int_distribution<int> digits(-1000, 1000);
  for (int i = 0; i < 2000; ++i) {
    const Rational a = Rational(digits(random)) / 7, b = Rational(digits(random)) / 3;
    const Mpfr_interval x(a, 64), y(b, 64);
    const auto holds = [](const Mpfr_interval& interval, const Rational& value) {
      return (interval - Mpfr_interval(value, 4096)).certain_sign() == 0;
    };
    EXPECT_TRUE(holds(x + y, a + b) && holds(x - y, a - b) && holds(x * y, a * b) && holds(-x, -a)) << a << ' ' << b;
    if (b != 0) {
      EXPECT_TRUE(holds(x / y, a / b)) << a << ' ' << b;
    }
    if (a > 0) {
      EXPECT_TRUE(holds(sqrt(x) * sqrt(x), a)) << a;
    }
  }
  EXPECT_EQ((Mpfr_interval(1) / Mpfr_interval(0)).certain_sign(), 0);
  EXPECT_EQ(sqrt(Mpfr_interval(-1)).certain_sign(), 0);
  EXPECT_EQ((Mpfr_interval(Rational(1) / 3, 64) - Mpfr_interval(Rational(33333) / 100000, 64)).certain_sign(), 1);
}

TEST(ProveSign, FindsSignsOfCloseRootsOnBothSides) {
  // (3 x - 1)^2 + d: positive for d > 0 however small, not for d < 0
  const verify::Integer_polynomial one({Integer(1)});
  for (int bits = 2; bits <= 40; bits += 2) {
    const Integer scale(std::ldexp(1.0, bits));
    const verify::Integer_polynomial square({Integer(1), Integer(-2), Integer(4)});  // Bernstein coefficients
    const verify::Integer_polynomial above = scale * square + one, below = scale * square - one;
    EXPECT_EQ(verify::prove_nonnegative(above), Proof::PROVEN) << bits;
    EXPECT_NE(verify::prove_nonnegative(below), Proof::PROVEN) << bits;
    EXPECT_EQ(verify::prove_nonnegative(Integer(-1) * above), Proof::DISPROVED) << bits;
  }
}

// An open sign, at an end or inside, is not taken for either.
TEST(ProveSign, TakesNoOpenSignForProven) {
  constexpr mpfr_prec_t BITS = 64;
  const Mpfr_interval one(Rational(1), BITS), third(Rational(1) / 3, BITS), open = third - third;
  ASSERT_EQ(open.certain_sign(), 0);
  for (const std::vector<Mpfr_interval>& coefficients :
       {std::vector<Mpfr_interval>{open, one, one}, std::vector<Mpfr_interval>{one, open, one},
        std::vector<Mpfr_interval>{one, one, open}})
    EXPECT_EQ(verify::prove_nonnegative(Bernstein_polynomial<Mpfr_interval>::from_scaled(coefficients), 0),
              Proof::UNDECIDED);
}

template <class Construction> class VerifyRegion : public testing::Test {};
using Constructions = testing::Types<Bca, Spiral_fat_arc, Bilens>;
TYPED_TEST_SUITE(VerifyRegion, Constructions);

TYPED_TEST(VerifyRegion, ProvesAllRegionsOfRandomCurves) {
  std::mt19937 random(SEED);
  for (int degree = 2; degree <= 6; ++degree)
    for (const bool rational : {false, true})
      for (int i = 0; i < bounding_arcs_test::cases(degree < 5 ? 3 : 2); ++i) {
        const auto curve = random_curve(random, degree, rational);
        for_each_piece<TypeParam>(curve, bounding_arcs_test::cases(6), [&](const auto& spiral, double t0, double t1) {
          EXPECT_TRUE(is_proven(verify_region<TypeParam>(spiral, t0, t1)))
              << "degree " << degree << (rational ? " rational" : "") << ", curve " << i << ", t " << t0 << ' ' << t1;
        });
      }
}

TYPED_TEST(VerifyRegion, ProvesNearLinearAndNearCircularPieces) {
  for (int bits = 0; bits <= 300; bits += 50) {
    const double d = std::ldexp(1.0, -bits);
    const Bezier_curve_2<double> flat({{0, 0}, {1.0 / 3, 0}, {2.0 / 3, d / 3}, {1, 4 * d / 3}});
    for_each_piece<TypeParam>(flat, 3, [&](const auto& spiral, double t0, double t1) {
      EXPECT_TRUE(is_proven(verify_region<TypeParam>(spiral, t0, t1)))
          << "d = 2^-" << bits << ", t " << t0 << ' ' << t1;
    });
  }
  for (int bits = 0; bits <= 52; bits += 4) {
    const double d = std::ldexp(1.0, -bits);
    const Bezier_curve_2<double> ellipse({{1, 0}, {1, 1 + d}, {0, 1 + d}}, {1, 0.75, 1});
    for_each_piece<TypeParam>(ellipse, 3, [&](const auto& spiral, double t0, double t1) {
      EXPECT_TRUE(is_proven(verify_region<TypeParam>(spiral, t0, t1)))
          << "d = 2^-" << bits << ", t " << t0 << ' ' << t1;
    });
  }
}

TYPED_TEST(VerifyRegion, ProvesLinesArcsInflectionsAndCusps) {
  const std::vector<Bezier_curve_2<double>> curves{
      Bezier_curve_2<double>({{0, 0}, {3, 1}}),
      Bezier_curve_2<double>({{0, 0}, {2, 1}, {-1, -0.5}, {4, 2}}),       // folded back
      Bezier_curve_2<double>({{1, 0}, {1, 0.5}, {0.6, 0.8}}, {1, 2, 5}),  // exact circular arc
      Bezier_curve_2<double>({{0, 0}, {1, 0}, {2, 0}, {3, 1}}),           // curvature 0 at the start
      Bezier_curve_2<double>({{0, 0}, {0, 0}, {1, 0}, {3, 2}}),           // zero-length handle
      Bezier_curve_2<double>({{0, 0}, {2, 3}, {3, 0}, {3, 0}}),
      Bezier_curve_2<double>({{0, 0}, {1, 1}, {0, 1}, {1, 0}})};  // cusp at 1/2
  for (std::size_t i = 0; i < curves.size(); ++i)
    for_each_piece<TypeParam>(curves[i], 4, [&](const auto& spiral, double t0, double t1) {
      EXPECT_TRUE(is_proven(verify_region<TypeParam>(spiral, t0, t1))) << "curve " << i << ", t " << t0 << ' ' << t1;
    });
}

// The formula's thickness, rounded up, is proven from the boundaries alone, and hardly less is not.
// A parabola from its vertex to where C' vanishes, the flat end: strictly in its region, with no room at a cut.
TYPED_TEST(VerifyRegion, ProvesASpiralWithAZeroHandleAtItsFlatEnd) {
  const Bezier_curve_2<double> curve({{0, 0}, {3, 0}, {5, 4}, {6, 6}, {6, 6}});  // x = 6 (2 t - t^2), y = x^2 / 6
  const auto spirals = spiral_segments(curve);
  ASSERT_EQ(spirals.size(), 1u);
  EXPECT_EQ(verify_region<TypeParam>(spirals[0], 0, 1).containment, Containment::PROVEN);
}

// What is past a vertex is held by the region with other curvatures at its ends: at the tight end of a parabola, and at
// the flat end of an arch. So nothing of the piece is out of that region.
TEST(VerifyRegion, HoldsSliversPastAVertexWithoutSlack) {
  const auto arch = std::make_shared<const Tabulated_bezier<double>>(
                 Bezier_curve_2<double>({{-1, 0}, {-1, 1}, {1, 1}, {1, 0}})),
             parabola =
                 std::make_shared<const Tabulated_bezier<double>>(Bezier_curve_2<double>({{-1, 1}, {0, -1}, {1, 1}}));
  for (const auto& curve : {arch, parabola})
    for (const auto& [t0, t1] : {std::pair(0.25, 0.5 + 0x1p-40), std::pair(0.5 - 0x1p-40, 0.75)}) {
      const Bezier_spiral_2<double> spiral(curve, t0, t1, {}, false);
      for (const Region_proof& proof :
           {verify_region<Spiral_fat_arc>(spiral, t0, t1), verify_region<Bilens>(spiral, t0, t1)}) {
        EXPECT_EQ(proof.containment, Containment::PROVEN_AS_SLIVER) << t0 << ' ' << t1;
        EXPECT_EQ(proof.slack, 0) << t0 << ' ' << t1;
      }
      // that region is no thinner than the piece's own, which tells nothing where less is asked
      for (const Region_proof& proof :
           {verify_region<Spiral_fat_arc>(spiral, t0, t1, 1e-9), verify_region<Bilens>(spiral, t0, t1, 1e-9)})
        EXPECT_FALSE(proof.holds() && proof.slack == 0) << t0 << ' ' << t1;
    }
}

// The widened shape is still one: its differences are those of its curvatures.
TEST(VerifyRegion, WidensCurvaturesAndTheirDifferencesAlike) {
  for (const auto& points : {std::vector<Xy<double>>{{0, 0}, {0.5, 0}, {1, 1}}, {{1, 1}, {0.5, 0}, {0, 0}}}) {
    const auto shape = spiral_segments(Bezier_curve_2<double>(points)).front().shape<Rational>(0, 1);
    const auto wide = verify::with_curvature_bounds(shape, 0x1p-4);
    const Rational square = dot(wide.chord, wide.chord);
    EXPECT_EQ(wide.kneser0, wide.curvature0 * square - wide.cross0 * dot(wide.tangent0, wide.tangent0));
    EXPECT_EQ(wide.kneser1, wide.cross1 * dot(wide.tangent1, wide.tangent1) - wide.curvature1 * square);
    const Rational tight = shape.tight_first ? wide.curvature0 - shape.curvature0 : wide.curvature1 - shape.curvature1,
                   flat = shape.tight_first ? wide.curvature1 - shape.curvature1 : wide.curvature0 - shape.curvature0;
    EXPECT_TRUE(shape.turn * tight > 0 && shape.turn * flat < 0) << shape.turn;
  }
}

TYPED_TEST(VerifyRegion, ProvesThicknessAndNoLess) {
  const auto construction = TypeParam();
  for (const auto& curve :
       {Bezier_curve_2<double>({{0, 0}, {0.5, 0}, {1, 1}}), Bezier_curve_2<double>({{0, 0}, {1, 2}, {2, -1}, {3, 1}}),
        Bezier_curve_2<double>({{0, 0}, {1, 3}, {-2, 1}, {1, 3}, {0, 0}})}) {
    if (bounding_arcs_test::FEW_CASES && curve.degree() > 2) break;
    for_each_piece<TypeParam>(curve, 1, [&](const auto& spiral, double t0, double t1) {
      const auto parts = shape_parts<TypeParam>();
      const auto shape = spiral.template shape<Rational>(t0, t1, parts);
      const double thickness = thickness_enclosure(construction, shape, 256).value().upper();
      EXPECT_TRUE(verify_thickness<TypeParam>(spiral, t0, t1, thickness)) << t0 << ' ' << t1;
      if (t0 == 0 && t1 == spiral.last()) {  // once a curve, as it takes all precisions in vain
        EXPECT_FALSE(verify_thickness<TypeParam>(spiral, t0, t1, thickness * (1 - 0x1p-40))) << t0 << ' ' << t1;
      }
    });
  }
}

// Around the joint of two segments, an arc that is farther from it in its middle than at its ends.
TEST(ThicknessProof, SeesTheMiddleOfAnArcBesideAJoint) {
  const auto point = [](int x, int y) { return Xy<Mpfr_interval>{Mpfr_interval(x), Mpfr_interval(y)}; };
  using Piece = Boundary_piece_2<Mpfr_interval>;
  using Chain = Boundary_chain_2<Mpfr_interval>;
  const Mpfr_interval straight(0), radius_10(-1);  // of normals of length 10
  const Region_boundary_2<Mpfr_interval> region{
      Chain(Piece{point(-20, -10), point(0, 0), {point(0, 0), point(-1, 2), straight}},
            Piece{point(0, 0), point(20, -10), {point(0, 0), point(1, 2), straight}}),
      Chain(Piece{point(-6, 13), point(6, 13), {point(-6, 13), point(-6, 8), radius_10}})};  // about (0, 5)
  const auto holds = [&](double length) {
    return verify::Thickness_proof(region, Mpfr_interval(Rational(length), 128), false, false).holds();
  };
  EXPECT_FALSE(holds(14.9));
  EXPECT_TRUE(holds(15.1));
}

// An arc of radius 25 over a line, 1 from it at its ends and 2 in the middle, its normal known so roughly that the
// slopes at its ends have no sign.
TEST(ThicknessProof, TakesNoOpenSlopesForNoExtremum) {
  using Chain = Boundary_chain_2<Mpfr_interval>;
  constexpr mpfr_prec_t BITS = 64;
  const auto point = [](int x, int y) { return Xy<Mpfr_interval>{Mpfr_interval(x), Mpfr_interval(y)}; };
  const Mpfr_interval third(Rational(1) / 3, BITS), open = Mpfr_interval(0x1p68) * (third - third);
  ASSERT_TRUE(open.lower() <= -8 && open.upper() >= 8 && open.upper() <= 16);
  const auto holds = [&](const Mpfr_interval& error, double length) {
    const Xy<Mpfr_interval> normal{Mpfr_interval(-7) + error, Mpfr_interval(24)};
    const Region_boundary_2<Mpfr_interval> region{
        Chain({point(-10, 0), point(10, 0), {point(-10, 0), point(0, 1), Mpfr_interval(0)}}),
        Chain({point(-7, 1), point(7, 1), {point(-7, 1), normal, Mpfr_interval(-1)}})};
    return verify::Thickness_proof(region, Mpfr_interval(Rational(length), BITS), false, false).holds();
  };
  EXPECT_FALSE(holds(Mpfr_interval(0), 1.9));
  EXPECT_TRUE(holds(Mpfr_interval(0), 2.1));
  EXPECT_FALSE(holds(open, 1.9));
  EXPECT_TRUE(holds(open, 100));
}

TEST(VerifyRegion, AsksLinesAndPointsForNoThickness) {
  for (const auto& curve :
       {Bezier_curve_2<double>({{0, 0}, {1, 1}, {0, 0}, {1, 1}}), Bezier_curve_2<double>({{1, 2}, {1, 2}})})
    for (const auto& spiral : spiral_segments(curve)) {
      EXPECT_TRUE(verify_thickness<Bilens>(spiral, spiral.first(), spiral.last(), 0));
      EXPECT_EQ(verify_region<Bilens>(spiral, spiral.first(), spiral.last()).containment, Containment::PROVEN);
    }
}

// A line that runs on past an end of its piece and comes back.
TEST(VerifyRegion, DisprovesALineThatLeavesItsEnds) {
  const Bezier_curve_2<double> fold({{0, 0}, {2, 2}, {1, 1}});
  const auto shared = std::make_shared<const Tabulated_bezier<double>>(fold);
  const Bezier_spiral_2<double> all(shared, 0, 1, {}, true);
  EXPECT_FALSE(is_proven(verify_region<Bca>(all, 0, 1, 0.1)));
}

// Constructions of one's own that are no regions, or others than BCAs.
struct No_edges : Oriented_box {
  template <class NT> static Region_outline_2<NT> boundary(const Chord_frame_2<NT>&) {
    return {{}, {}, Outline_form::POLYGON};
  }
};
struct One_side : Oriented_box {
  template <class NT> static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    auto outline = Oriented_box::boundary(frame);
    outline.inner.clear();
    return outline;
  }
};
struct Open_side : Oriented_box {
  template <class NT> static Region_outline_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    auto outline = Oriented_box::boundary(frame);
    outline.outer.pop_back();
    return outline;
  }
};
struct Flat_sagitta : bounding_arcs_test::Sagitta {  // its arc is the chord, too
  template <class NT> static Region_boundary_2<NT> boundary(const Chord_frame_2<NT>& frame) {
    auto region = bounding_arcs_test::Sagitta::boundary(frame);
    region.outer = region.inner;
    return region;
  }
};

TEST(VerifyRegion, TakesNoOutlineWithoutAnInsideForARegion) {
  const auto spiral = spiral_segments(Bezier_curve_2<double>({{0, 0}, {0.5, 0}, {1, 1}})).front();
  EXPECT_TRUE(is_proven(verify_region<Oriented_box>(spiral, 0, 1)));
  EXPECT_FALSE(is_proven(verify_region<No_edges>(spiral, 0, 1)));
  EXPECT_FALSE(is_proven(verify_region<One_side>(spiral, 0, 1)));
  EXPECT_FALSE(is_proven(verify_region<Open_side>(spiral, 0, 1)));
  EXPECT_TRUE(verify_thickness<Oriented_box>(spiral, 0, 1, 1));
  EXPECT_FALSE(verify_thickness<No_edges>(spiral, 0, 1, 1));
  EXPECT_FALSE(verify_thickness<One_side>(spiral, 0, 1, 1));
}

TEST(VerifyRegion, LooksAtTheArcsOfOnesOwnConstruction) {
  for (const auto& curve : {Bezier_curve_2<double>({{0, 0}, {0.5, 0}, {1, 1}}),
                            Bezier_curve_2<double>({{0, 0}, {0.5, 0.25}, {1, -2}}, {1, 2, 1})})
    for_each_piece<Bca>(curve, 3, [&](const auto& spiral, double t0, double t1) {
      EXPECT_TRUE(is_proven(verify_region<bounding_arcs_test::Sagitta>(spiral, t0, t1)));
      EXPECT_FALSE(is_proven(verify_region<Flat_sagitta>(spiral, t0, t1)));
    });
}

TEST(VerifyRegion, DisprovesPiecesThatAreNoSpirals) {
  // a parabola with its vertex inside, as if it were one segment
  const Bezier_curve_2<double> parabola({{-1, 1}, {0.125, -1.25}, {1.25, 1.5625}});
  const auto shared = std::make_shared<const Tabulated_bezier<double>>(parabola);
  const Bezier_spiral_2<double> all(shared, 0, 1, {}, false);
  EXPECT_EQ(verify_region<Bca>(all, 0, 1, 0.1).containment, Containment::DISPROVED);
  EXPECT_FALSE(is_proven(verify_region<Bilens>(all, 0, 1)));
  EXPECT_FALSE(is_proven(verify_region<Spiral_fat_arc>(all, 0, 1)));
}

TEST(VerifyRegion, NoticesConstructionsThatAreSlightlyWrong) {
  const Bezier_curve_2<double> parabola({{0, 0}, {0.5, 0}, {1, 1}});
  for_each_piece<Bilens>(parabola, 2, [&](const auto& spiral, double t0, double t1) {
    EXPECT_TRUE(is_proven(verify_region<Bilens>(spiral, t0, t1)));
    // a contact circle bent either way no longer touches the osculating one at the joint; bent inwards far enough it
    // cuts the curve
    EXPECT_TRUE(is_proven(verify_region<Bent_bilens<-1>>(spiral, t0, t1)));
  });
  // at the last halvings the room between curve and circle is below the error, and the region cuts the curve
  const auto spiral = spiral_segments(parabola).front();
  EXPECT_FALSE(is_proven(verify_region<Bent_bilens<+1>>(spiral, 0.5, 0.5 + std::ldexp(1.0, -22))));
  EXPECT_TRUE(is_proven(verify_region<Bilens>(spiral, 0.5, 0.5 + std::ldexp(1.0, -22))));
}

}  // namespace
}  // namespace test_verify
