// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as curves of Arr_circular_line_arc_traits_2: the right one of the two arcs of an exact circle through both ends,
// the same circle as for the other traits, and what comes back.

#include <CGAL/Bounding_arcs_2/exchange/add_to_drawing.h>
#include <CGAL/Bounding_arcs_2/exchange/circle_segment_curve.h>
#include <CGAL/Bounding_arcs_2/exchange/circular_line_curve.h>
#include <CGAL/Bounding_arcs_2/exchange/widened_outline.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

namespace test_exchange_circular {
namespace {

using namespace CGAL::Bounding_arcs;
using FT = CGAL::Exact_rational;
using Rational_kernel = CGAL::Circular_kernel_2<CGAL::Simple_cartesian<FT>, CGAL::Algebraic_kernel_for_circles_2_2<FT>>;

template <class K> class CircularLineCurve : public testing::Test {};
using Kernels = testing::Types<CGAL::Exact_circular_kernel_2, Rational_kernel>;
TYPED_TEST_SUITE(CircularLineCurve, Kernels);

const Xy<double> FROM{0.1, -0.3}, TO{1e-3, 7.7};

template <class K> using Traits = CGAL::Arr_circular_line_arc_traits_2<K>;
template <class K> const typename K::Circular_arc_2& arc_in(const typename Traits<K>::Curve_2& curve) {
  const auto* arc = get_if<typename K::Circular_arc_2>(curve);
  if (arc == nullptr) throw std::logic_error("the curve is no arc");
  return *arc;
}
template <class K> auto parts_of(const Arc_2& arc) {
  std::vector<typename Traits<K>::X_monotone_curve_2> parts;
  x_monotone_parts<Traits<K>>(circular_line_curve<K>(arc), std::back_inserter(parts));
  return parts;
}

TYPED_TEST(CircularLineCurve, IsTheArcOfTheExactCircleOnTheSideOfTheBulge) {
  using K = TypeParam;
  using NT = typename K::FT;
  const auto at = [](const Xy<NT>& p) { return typename K::Circular_arc_point_2(internal::kernel_point<K>(p)); };
  const Xy<NT> from{NT(FROM.x), NT(FROM.y)}, to{NT(TO.x), NT(TO.y)}, chord = to - from;
  for (const double size : {1e-300, 1e-20, 1e-9, 0.01, 0.3, 0.7, 1.0})
    for (const double bulge : {size, -size}) {
      const auto curve = circular_line_curve<K>(Arc_2{FROM, TO, bulge});
      const auto& arc = arc_in<K>(curve);
      EXPECT_TRUE(arc.source() == at(bulge > 0 ? from : to)) << bulge;
      EXPECT_TRUE(arc.target() == at(bulge > 0 ? to : from)) << bulge;
      const auto& circle = arc.supporting_circle();
      const NT b(bulge);
      const Xy<NT> apex = from + NT(NT(1) / NT(2)) * chord - NT(b / NT(2)) * perp(chord);
      for (const Xy<NT>& p : {from, to, apex})
        EXPECT_EQ(circle.bounded_side(internal::kernel_point<K>(p)), CGAL::ON_BOUNDARY) << bulge;
      // counterclockwise, so to the right of its chord
      const Xy<NT>&source = bulge > 0 ? from : to, &target = bulge > 0 ? to : from;
      EXPECT_EQ(CGAL::orientation(internal::kernel_point<K>(source), internal::kernel_point<K>(target),
                                  internal::kernel_point<K>(apex)),
                CGAL::RIGHT_TURN)
          << bulge;
    }
}

TYPED_TEST(CircularLineCurve, IsASegmentWithoutBulgeAndNothingWithoutLength) {
  using K = TypeParam;
  const auto curve = circular_line_curve<K>(Arc_2{FROM, TO, 0});
  const auto* segment = get_if<typename K::Line_arc_2>(curve);
  ASSERT_NE(segment, nullptr);
  EXPECT_EQ(arcs_of(*segment).front().from, FROM);
  EXPECT_EQ(arcs_of(*segment).front().to, TO);
  for (const double bulge : {0.0, 0.5})
    EXPECT_THROW((void)circular_line_curve<K>(Arc_2{FROM, FROM, bulge}), std::invalid_argument) << bulge;
  EXPECT_THROW((void)circular_line_curve<K>(Arc_2{FROM, TO, std::nan("")}), std::invalid_argument);
  EXPECT_THROW((void)circular_line_curve<K>(Arc_2{{HUGE_VAL, 0}, TO, 0.5}), std::invalid_argument);
}

TYPED_TEST(CircularLineCurve, FallsIntoXMonotoneArcsThatAreTheWhole) {
  using K = TypeParam;
  EXPECT_EQ(parts_of<K>({FROM, TO, 0}).size(), 1U);
  EXPECT_EQ(parts_of<K>({{0, 0}, {0, 1}, 1}).size(), 2U);  // the right half of a circle
  EXPECT_EQ(parts_of<K>({{0, 0}, {1, 0}, 1}).size(), 1U);  // its lower half
  for (const Arc_2& arc :
       {Arc_2{FROM, TO, 0.4}, Arc_2{FROM, TO, -1e-7}, Arc_2{{3, 1}, {2, 2}, -1}, Arc_2{FROM, TO, 0}}) {
    double sum = 0;
    for (const auto& part : parts_of<K>(arc))
      for (const Arc_2& again : arcs_of(part)) sum += length(again);
    EXPECT_NEAR(sum, length(arc), 1e-14 * length(arc)) << arc.bulge;
  }
}

TEST(CircularLineCurves, HaveTheCirclesOfTheOtherTraits) {
  for (const double bulge : {-0.9, -1e-9, 0.25, 1.0}) {
    const Arc_2 arc{FROM, TO, bulge};
    const auto curve = circular_line_curve<Rational_kernel>(arc);
    const auto& circle = arc_in<Rational_kernel>(curve).supporting_circle();
    const auto other = circle_segment_curve(arc).supporting_circle();
    EXPECT_EQ(circle.center().x(), CGAL::exact(other.center().x())) << bulge;
    EXPECT_EQ(circle.center().y(), CGAL::exact(other.center().y())) << bulge;
    EXPECT_EQ(circle.squared_radius(), CGAL::exact(other.squared_radius())) << bulge;
  }
  EXPECT_THROW((void)circle_segment_curve({FROM, FROM, 0.5}), std::invalid_argument);
}

// The circle over a diameter from (0, -y) to (1, 0) passes the origin, whatever y is.
TEST(CircularLineCurves, MeetWhereTheirArcsDoExactly) {
  using K = CGAL::Exact_circular_kernel_2;
  using Part = Traits<K>::X_monotone_curve_2;
  const auto segment = parts_of<K>({{0, 0}, {1, 0}, 0});
  std::vector<Variant<std::pair<K::Circular_arc_point_2, unsigned>, Part>> found;
  for (const Part& part : parts_of<K>({{0, -0.1}, {1, 0}, -1}))
    Traits<K>().intersect_2_object()(part, segment.front(), std::back_inserter(found));
  std::vector<K::Circular_arc_point_2> points;
  for (const auto& object : found) {
    const auto* point = get_if<std::pair<K::Circular_arc_point_2, unsigned>>(object);
    ASSERT_NE(point, nullptr);
    points.push_back(point->first);
  }
  ASSERT_EQ(points.size(), 2U);
  std::sort(points.begin(), points.end(), [](const auto& p, const auto& q) { return p.x() < q.x(); });
  for (int i = 0; i < 2; ++i)
    EXPECT_TRUE(points[static_cast<std::size_t>(i)] == K::Circular_arc_point_2(K::Point_2(i, 0))) << i;
}

// Where one curve ends the next one starts, exactly.
TEST(CircularLineCurves, OfAnOutlineOfARegionInDoublesAreClosed) {
  using K = Rational_kernel;
  Arc_region_2 region{{0.3, 0.2}, {1.3, 0.7}, {1, {0.05, 0}, {}}, {1, {0.1, 0}, {}}};
  region.widening = 1e-9;
  const Widened_outline outline = widened_outline(region);
  std::vector<K::Circular_arc_point_2> starts, ends;
  for (const Arc_2& arc : outline.arcs) {
    const auto piece = kernel_piece<K>(exact_piece<FT>(arc));
    const auto add = [&](const auto& curve) {
      starts.push_back(piece.reversed ? curve.target() : curve.source());
      ends.push_back(piece.reversed ? curve.source() : curve.target());
    };
    if (const auto* round = std::get_if<K::Circular_arc_2>(&piece.curve)) add(*round);
    else add(std::get<K::Line_arc_2>(piece.curve));
  }
  ASSERT_GE(starts.size(), 4U);
  for (std::size_t i = 0; i < starts.size(); ++i) EXPECT_TRUE(ends[i] == starts[(i + 1) % starts.size()]) << i;
}

// As a kernel boundary has them: arcs, segments, and tangents between two algebraic points.
TEST(CircularLineCurves, OfKernelBoundariesAreAllOnRationalCirclesAndLines) {
  using K = Rational_kernel;
  const Xy<FT> from{FT(0), FT(0)}, joint{FT(1), FT(0)}, to{FT(2), FT(1)};
  const auto side = internal::kernel_chain<K>(
      Boundary_chain_2<FT>(piece_on_chord(from, joint, FT(-0.25)), piece_on_chord(joint, to, FT(0))));
  EXPECT_NE(get_if<K::Circular_arc_2>(circular_line_curve(side[0])), nullptr);
  EXPECT_NE(get_if<K::Line_arc_2>(circular_line_curve(side[1])), nullptr);
  const Kernel_piece_2<K> tangent{Algebraic_segment_2<K>{K::Circular_arc_point_2(internal::kernel_point<K>(from)),
                                                         K::Circular_arc_point_2(internal::kernel_point<K>(to))}};
  EXPECT_THROW((void)circular_line_curve(tangent), std::invalid_argument);
}

}  // namespace
}  // namespace test_exchange_circular
