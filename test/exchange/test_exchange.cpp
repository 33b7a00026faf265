// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is handed to CGAL's arrangements and Boolean set operations: exact circles through the ends, polygons with
// holes, regions moved outward that hold all that they promise, areas between bounds.

#include "bulge_arcs.h"

#include <CGAL/Bounding_arcs_2/exchange/general_polygon.h>
#include <CGAL/Bounding_arcs_2/exchange/widened_outline.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <CGAL/Boolean_set_operations_2/Gps_polygon_validation.h>
#include <CGAL/General_polygon_set_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace test_exchange {
namespace {

using namespace CGAL::Bounding_arcs;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Part = Traits::X_monotone_curve_2;
using Polygon_set = CGAL::General_polygon_set_2<Traits>;

std::vector<Part> parts_of(const Arc_2& arc) {
  std::vector<Part> parts;
  x_monotone_parts(circle_segment_curve(arc), std::back_inserter(parts));
  return parts;
}

// CGAL's own preconditions, that the ends are on the circle, are on in this program.
TEST(CircleSegmentCurve, RunsFromEndToEndOnTheExactCircle) {
  const Xy<double> from{0.1, -0.3}, to{1e-3, 7.7};
  for (const double size : {1e-300, 1e-20, 1e-9, 0.01, 0.3, 0.7, 1.0})
    for (const double bulge : {size, -size}) {
      const auto parts = parts_of({from, to, bulge});
      ASSERT_GE(parts.size(), 1U) << bulge;
      EXPECT_TRUE(parts.front().source() == Traits::Point_2(Kernel::FT(from.x), Kernel::FT(from.y))) << bulge;
      EXPECT_TRUE(parts.back().target() == Traits::Point_2(Kernel::FT(to.x), Kernel::FT(to.y))) << bulge;
      for (std::size_t i = 0; i + 1 < parts.size(); ++i) EXPECT_TRUE(parts[i].target() == parts[i + 1].source());
      EXPECT_EQ(parts.front().orientation(), bulge > 0 ? CGAL::COUNTERCLOCKWISE : CGAL::CLOCKWISE);
      // 4 b R = (1 + b^2) L
      const CGAL::Exact_rational b(bulge), x(to.x), y(to.y), u(from.x), v(from.y),
          square((x - u) * (x - u) + (y - v) * (y - v)), root(1 + b * b);
      EXPECT_EQ(CGAL::exact(parts.front().supporting_circle().squared_radius()),
                CGAL::Exact_rational(square * root * root / (16 * b * b)));
    }
  EXPECT_EQ(parts_of({from, to, 0}).front().orientation(), CGAL::COLLINEAR);
  EXPECT_EQ(parts_of({{0, 0}, {0, 1}, 1}).size(), 2U);  // the right half of a circle
  EXPECT_EQ(parts_of({{0, 0}, {1, 0}, 1}).size(), 1U);  // its lower half
  EXPECT_EQ(parts_of({{0, 0}, {1, 1}, 1}).size(), 2U);
  EXPECT_THROW((void)parts_of({from, to, std::nan("")}), std::invalid_argument);
}

TEST(PolygonArea, BracketsClosedForms) {
  const double pi = 3.14159265358979323846;
  for (const double size : {1e-6, 1.0, 1e6})
    for (const double bulge : {1.0, 0.5, 0.1, 1e-3}) {
      // twice the segment of a circle
      const Xy<double> a{3 * size, size}, b{4 * size, 3 * size};
      const double angle = 4 * std::atan(bulge), r = std::sqrt(5) * size * (1 + bulge * bulge) / (4 * bulge);
      const double expected = r * r * (angle - std::sin(angle));
      const Measure_bounds area = polygon_area(general_polygon(std::vector<Arc_2>{{a, b, bulge}, {b, a, bulge}}));
      const double slack = 1e-9 * expected;  // of the closed form, whose digits cancel
      EXPECT_LE(area.lower, expected + slack) << size << " " << bulge;
      EXPECT_GE(area.upper, expected - slack) << size << " " << bulge;
      EXPECT_LE(area.upper - area.lower, 1e-13 * size * size) << size << " " << bulge;
    }
  const Measure_bounds disc =
      polygon_area(general_polygon(std::vector<Arc_2>{{{-1, 0}, {1, 0}, 1}, {{1, 0}, {-1, 0}, 1}}));
  EXPECT_LE(disc.lower, pi);
  EXPECT_GE(disc.upper, pi);
  EXPECT_LE(disc.upper - disc.lower, 1e-14);
}

TEST(GeneralPolygon, RunsCounterclockwiseAndIsClosed) {
  const std::vector<Arc_2> clockwise{{{0, 0}, {0, 1}, 0}, {{0, 1}, {1, 1}, -0.2}, {{1, 1}, {0, 0}, 0}};
  EXPECT_GT(polygon_area(general_polygon(clockwise)).lower, 0.5);
  EXPECT_THROW((void)general_polygon(std::vector<Arc_2>{{{0, 0}, {0, 1}, 0}, {{0, 1}, {1, 1}, 0}}),
               std::invalid_argument);
}

TEST(RegionPolygon, IsNothingWithoutArea) {
  using FT = Kernel::FT;
  const Xy<FT> from{FT(0), FT(0)}, to{FT(1), FT(0)};
  const auto region = [&](double inner, double outer) {
    return Region_boundary_2<FT>{Boundary_chain_2<FT>(piece_on_chord(from, to, FT(inner))),
                                 Boundary_chain_2<FT>(piece_on_chord(from, to, FT(outer)))};
  };
  EXPECT_FALSE(general_polygon(region(0, 0)));
  EXPECT_FALSE(general_polygon(region(0.25, 0.25)));
  for (const auto& r : {region(0, 0.25), region(0.125, 0.25), region(-0.125, -0.25)}) {
    const auto polygon = general_polygon(r);
    ASSERT_TRUE(polygon);
    EXPECT_TRUE(CGAL::is_valid_polygon(*polygon, Traits()));
    EXPECT_GT(polygon_area(*polygon).lower, 0.01);
  }
}

Drawing_2<double> square_with_hole() {
  Drawing_2<double> drawing;
  for (const double r : {4.0, 1.0}) {
    const Xy<double> corners[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
    std::vector<Bezier_curve_2<double>> sides;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto p = corners[r > 2 ? i : (4 - i) % 4], q = corners[r > 2 ? (i + 1) % 4 : (7 - i) % 4];
      sides.push_back(Bezier_curve_2<double>({p, q}));
    }
    drawing.add(std::move(sides));
  }
  return drawing;
}

TEST(OffsetPolygons, HaveTheirHolesAndAreas) {
  const double pi = 3.14159265358979323846;
  const Offset_source_2 source(Bounding_arc_tree_2(square_with_hole()), 1e-6);
  const auto grown = offset_polygons(source.at(0.5)), shrunk = offset_polygons(source.at(-0.5));
  ASSERT_EQ(grown.size(), 1U);
  ASSERT_EQ(shrunk.size(), 1U);
  EXPECT_EQ(grown[0].number_of_holes(), 1U);
  EXPECT_NEAR(polygon_area(grown[0]).lower, 64 + 16 + pi / 4 - 1, 1e-9);
  EXPECT_NEAR(polygon_area(shrunk[0]).upper, 49 - 4 - 4 - pi / 4, 1e-9);
  for (const auto& part : {grown[0], shrunk[0]}) EXPECT_TRUE(CGAL::is_valid_polygon_with_holes(part, Traits()));
  EXPECT_TRUE(offset_polygons(source.at(-2)).empty());
}

// Regions with sides of one and of two arcs, some with a corner on the outer side, turning left or right, up to 90
// degrees in all, and thin ones.
std::vector<Arc_region_2> regions() {
  std::vector<Arc_region_2> all;
  for (const double turn : {0.0, 1e-9, 0.05, 0.19})
    for (const double sign : {1.0, -1.0}) {
      const Xy<double> from{0.3, 0.2}, to{1.3, 0.7};
      const double b = sign * turn;
      all.push_back({from, to, {1, {b, 0}, {}}, {1, {2 * b, 0}, {}}});
      const Xy<double> chord = to - from, joint = from + (0.4 * chord - (0.45 * b) * perp(chord)),
                       corner = from + (0.45 * chord - b * perp(chord));
      all.push_back({from, to, {2, {b / 4, b / 4}, joint}, {2, {0, b / 3}, corner}});
      const Xy<double> near_end = to - 1e-6 * (chord + (2.5 * b) * perp(chord));  // where an arc of 1.5 b passes
      all.push_back({from, to, {1, {b, 0}, {}}, {2, {1.5 * b, b / 4}, near_end}});
    }
  return all;
}

std::vector<Arc_2> arcs_of_side(const Arc_region_2& region, const Arc_region_2::Side& side) {
  if (side.size == 1) return {{region.from, region.to, side.bulges[0]}};
  return {{region.from, side.joint, side.bulges[0]}, {side.joint, region.to, side.bulges[1]}};
}
// In units of the widening a point of the disc around a point of a side may be at its rim.
TEST(WidenedOutline, HoldsAllThatIsAsNearAsTheWidening) {
  for (Arc_region_2 region : regions())
    for (const double widening : {1e-15, 1e-9, 1e-4, 0.01}) {
      region.widening = widening;
      const Widened_outline outline = widened_outline(region);
      const auto polygon = general_polygon(outline.arcs);
      ASSERT_TRUE(CGAL::is_valid_polygon(polygon, Traits()))
          << widening << ", bulges " << region.inner.bulges[0] << " " << region.outer.bulges[0] << ", arcs "
          << region.outer.size;
      const Polygon_set set(polygon);
      for (const Arc_region_2::Side& side : {region.inner, region.outer})
        for (const Arc_2& arc : arcs_of_side(region, side))
          for (int i = 0; i <= 6; ++i)
            for (int k = 0; k < 8; ++k) {
              const double angle = k * 0.78539816339744828;
              const Xy<double> p =
                  bounding_arcs_test::point_on(arc, i / 6.0) + widening * Xy<double>{std::cos(angle), std::sin(angle)};
              const Traits::Point_2 q{Kernel::FT(p.x), Kernel::FT(p.y)};
              EXPECT_NE(set.oriented_side(q), CGAL::ON_NEGATIVE_SIDE)
                  << widening << ": " << p.x << " " << p.y << ", bulge " << region.outer.bulges[0];
            }
      for (const Arc_2& arc : outline.arcs) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Arc_region_2::Side& side : {region.inner, region.outer})
          for (const Arc_2& of_region : arcs_of_side(region, side))
            nearest = (std::min)(nearest, bounding_arcs_test::distance_from(of_region, arc.from));
        EXPECT_LE(nearest, outline.reach);
      }
      if (widening < 1e-3) {
        EXPECT_LE(outline.reach, 80 * widening + 1e-13) << widening;
      }
    }
}

TEST(WidenedOutline, IsABoxAroundWhatIsShorter) {
  Arc_region_2 region{{1, 1}, {1 + 1e-9, 1}, {1, {0.1, 0}, {}}, {1, {0.2, 0}, {}}};
  region.widening = 1e-6;
  const Widened_outline outline = widened_outline(region);
  ASSERT_EQ(outline.arcs.size(), 4U);
  EXPECT_LE(outline.arcs[0].from.x, 1 - 1e-6);
  EXPECT_GE(outline.arcs[2].from.y, 1 + 1e-6);
  region.widening = std::numeric_limits<double>::infinity();
  EXPECT_THROW((void)widened_outline(region), std::invalid_argument);
}

}  // namespace
}  // namespace test_exchange
