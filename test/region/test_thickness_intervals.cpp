// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness of spiral fat arcs over intervals that leave open whether the outer arc has a tangent parallel to the inner
// segment: an enclosure holds both answers.

#include "cases.h"

#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace test_thickness_intervals {
namespace {

using namespace CGAL::Bounding_arcs;
using Exact = CGAL::Exact_rational;
using Interval = CGAL::Interval_nt<true>;

constexpr mpfr_prec_t PRECISION = 256;

/// A spiral over the chord (1, 0) whose start is tight: tangents of its angles and second derivatives, each with the
/// share of itself that it may be off.
struct Box {
  std::array<double, 4> numbers, shares;
  [[nodiscard]] double low(std::size_t i) const { return numbers[i] * (1 - shares[i]); }
  [[nodiscard]] double high(std::size_t i) const { return numbers[i] * (1 + shares[i]); }
};

template <class NT> Chord_shape_2<NT> shape_of(const std::array<NT, 4>& x) {
  const End_jet_2<NT> start{{NT(0), NT(0)}, {NT(1), NT(-x[0])}, {NT(0), x[2]}},
      end{{NT(1), NT(0)}, {NT(1), x[1]}, {NT(0), x[3]}};
  return chord_frame<NT>(start, end).shape;
}

// None where the intervals leave the shape's signs open.
std::optional<Interval> thickness_over(const Box& box) {
  std::array<Interval, 4> x;
  for (std::size_t i = 0; i < 4; ++i) x[i] = Interval(box.low(i), box.high(i));
  try {
    const Chord_shape_2<Interval> shape = shape_of(x);
    if (!shape.proper || !shape.tight_first) return std::nullopt;
    return Spiral_fat_arc::thickness(shape);
  } catch (const CGAL::Uncertain_conversion_exception&) {
    return std::nullopt;
  }
}

// Holds an enclosure against the thickness at the box's corners and its center.
void expect_encloses(const Interval& enclosure, const Box& box) {
  for (std::size_t corner = 0; corner <= 16; ++corner) {
    std::array<Exact, 4> x;
    for (std::size_t i = 0; i < 4; ++i)
      x[i] = Exact(corner == 16 ? box.numbers[i] : (corner >> i & 1) != 0 ? box.high(i) : box.low(i));
    const auto thickness = Spiral_fat_arc::thickness(
        shape_of(x).over<Mpfr_interval>([](const Exact& e) { return Mpfr_interval(e, PRECISION); }));
    ASSERT_GE((thickness - Mpfr_interval(Exact(enclosure.inf()), PRECISION)).certain_sign(), 0) << corner;
    ASSERT_GE((Mpfr_interval(Exact(enclosure.sup()), PRECISION) - thickness).certain_sign(), 0) << corner;
  }
}

// Of these boxes the corner's distance alone is no enclosure.
TEST(SpiralFatArcThickness, OverIntervalsHoldsBothSidesOfItsSwitch) {
  const std::vector<Box> boxes = {
      {{0.119584, 0.0709114, 0.608743, 0.113272}, {0.16384, 0.00029, 0.0125854, 0.00045}},
      {{0.0850574, 0.0700493, 0.412409, 0.12507}, {0.00511393, 0.0135869, 0.411892, 0.0272702}},
      {{0.453034, 0.124582, 4.06223, 0.135608}, {0.00240715, 0.0381984, 0.00218864, 0.00102396}},
      {{0.155613, 0.10752, 0.64185, 0.147919}, {0.00443953, 0.0192824, 0.0400134, 0.000949722}},
      {{0.458217, 0.291027, 3.86739, 0.57232}, {0.0651073, 0.00403332, 0.229023, 0.00453046}}};
  for (const Box& box : boxes) {
    const std::optional<Interval> enclosure = thickness_over(box);
    ASSERT_TRUE(enclosure.has_value());
    expect_encloses(*enclosure, box);
  }
}

TEST(SpiralFatArcThickness, OverIntervalsEnclosesThatOfEveryShapeInside) {
  std::mt19937 random(821);
  std::uniform_real_distribution<double> unit(0, 1);
  const int count = bounding_arcs_test::cases(1500);
  int enclosed = 0, undecided = 0;
  for (int i = 0; i < count; ++i) {
    Box box;
    const double tight = std::exp2(-4 + 3 * unit(random)), flat = tight * unit(random), bend = unit(random);
    box.numbers = {tight, flat, 2 * tight * (1 + 12 * bend * bend), 2 * flat * unit(random)};
    for (double& share : box.shares) share = std::exp2(-12 + 11 * unit(random));
    const std::optional<Interval> enclosure = thickness_over(box);
    ++(enclosure ? enclosed : undecided);
    if (!enclosure) continue;
    ASSERT_NO_FATAL_FAILURE(expect_encloses(*enclosure, box)) << i;
  }
  EXPECT_GT(enclosed, count / 4);
  EXPECT_GT(undecided, count / 15);
}

// Where nothing is open an enclosure is hardly wider than what goes in.
TEST(SpiralFatArcThickness, OverNarrowIntervalsIsNarrow) {
  std::mt19937 random(822);
  std::uniform_real_distribution<double> unit(0.25, 0.75);
  for (int i = 0; i < 200; ++i) {
    const double tight = unit(random) / 4, flat = tight * unit(random), share = 0x1p-40;
    const Box box{{tight, flat, 4 * tight * (1 + unit(random)), 2 * flat * unit(random)}, {share, share, share, share}};
    const std::optional<Interval> enclosure = thickness_over(box);
    ASSERT_TRUE(enclosure.has_value());
    ASSERT_NO_FATAL_FAILURE(expect_encloses(*enclosure, box));
    EXPECT_LT(enclosure->sup() - enclosure->inf(), 0x1p-30 * enclosure->sup());
  }
}

}  // namespace
}  // namespace test_thickness_intervals
