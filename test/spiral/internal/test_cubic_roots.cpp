// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter for roots of cubics' numerators against the plain algorithm: where it answers, the same bits.

#include "../../../src/library/spiral/Cubic_roots.h"
#include "../../../src/library/spiral/spiral_cuts.h"
#include "cases.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace test_cubic_roots {
namespace {

using namespace CGAL::Bounding_arcs;
using internal::CURVATURE_CHANGE;
using internal::INFLECTION;
using internal::NUMERATOR_COUNT;
using internal::SPEED_X;
using internal::SPEED_Y;
using Cubic = std::array<Xy<double>, 4>;

constexpr unsigned SEED = 1303;

Bezier_curve_2<double> curve(const Cubic& p) {
  return Bezier_curve_2<double>(std::vector<Xy<double>>(p.begin(), p.end()));
}

// Random numbers and the curves made of them.
class Source {
 public:
  double uniform(double size = 1) { return std::uniform_real_distribution<double>(-size, size)(engine_); }
  double integer(int size) { return std::uniform_int_distribution<int>(-size, size)(engine_); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  double power(int least, int most) { return std::ldexp(1.0, least + below(most - least + 1)); }

  Cubic uniform_points() {
    return points([&] { return uniform(); });
  }
  Cubic grid(int size) {
    return points([&] { return integer(size); });
  }
  template <class Number> static Cubic points(Number number) {
    Cubic p;
    for (Xy<double>& q : p) {
      q.x = number();
      q.y = number();
    }
    return p;
  }

 private:
  std::mt19937_64 engine_{SEED};
};

Cubic scaled(Cubic p, double x, double y) {
  for (Xy<double>& q : p) q = {x * q.x, y * q.y};
  return p;
}
Cubic turned(Cubic p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Xy<double>& q : p) q = {c * q.x - s * q.y, s * q.x + c * q.y};
  return p;
}
Cubic reversed_if(bool is_reversed, const Cubic& p) { return is_reversed ? Cubic{p[3], p[2], p[1], p[0]} : p; }

Cubic near_circular(Source& r) {
  const double angle = 0.1 + std::abs(r.uniform(1.4)), c = std::cos(angle), s = std::sin(angle),
               k = 4.0 / 3 * std::tan(angle / 4), off = r.below(2) * r.power(-52, -10);
  return turned({{{1 + off * r.uniform(), 0}, {1, k}, {c + k * s, s - k * c}, {c, s + off * r.uniform()}}},
                r.uniform(3));
}

// C' = 3 (t - at) (u + t v); over integers without a rounding.
Cubic cusp(Source& r, bool is_exact) {
  const double scale = is_exact ? 1 : 1.0 / 7, at = is_exact ? r.integer(8) / 8 : r.uniform();
  Cubic p{};
  for (double Xy<double>::*x : {&Xy<double>::x, &Xy<double>::y}) {
    const double u = 16 * scale * r.integer(9), v = 16 * scale * r.integer(9);
    p[1].*x = p[0].*x - at * u;
    p[2].*x = p[1].*x + (u * (1 - at) - at * (u + v)) / 2;
    p[3].*x = p[2].*x + (1 - at) * (u + v);
  }
  return p;
}

// The first two legs are parallel, exactly or nearly so.
Cubic inflection_at_end(Source& r) {
  const Xy<double> leg{r.integer(9), r.integer(9)};
  const double off = r.below(2) * r.power(-52, -30);
  return reversed_if(r.below(2) == 1,
                     {{{0, 0}, leg, {(1 + off) * 3 * leg.x, 3 * leg.y}, {r.integer(20), r.integer(20)}}});
}

Cubic double_point(Source& r) {
  Cubic p = r.grid(5);
  const int i = r.below(3);
  p[static_cast<std::size_t>(i) + 1] = p[static_cast<std::size_t>(i)];
  return p;
}

// A first leg so nearly vertical that x' has a root next to the end, on either side of it.
Cubic nearly_vertical_at_end(Source& r) {
  Cubic p = r.uniform_points();
  p[0].x = 0;
  p[1].x = (2 * r.below(2) - 1) * r.power(-70, -48);
  return reversed_if(r.below(2) == 1, p);
}

double gap(Source& r) { return r.power(-24, -18) * (1 + std::abs(r.uniform())); }

// x' or y' = w (t - a) (t - a - s), whose roots are a gap s apart.
Cubic nearly_level_twice(Source& r) {
  const double a = std::abs(r.uniform()), s = gap(r), w = r.uniform();
  const double legs[] = {w * a * (a + s), w * (a * (a + s) - (a + s / 2)), w * (1 - a) * (1 - a - s)};
  Cubic p = r.uniform_points();
  double Xy<double>::*x = r.below(2) == 0 ? &Xy<double>::x : &Xy<double>::y;
  p[0].*x = 0;
  for (std::size_t i = 0; i < 3; ++i) p[i + 1].*x = p[i].*x + legs[i];
  return p;
}

// A cusp that is moved by the square of a gap, so that inflections are that far apart, or a loop is as small.
Cubic nearly_cusp(Source& r) {
  Cubic p = cusp(r, false);
  const double s = gap(r);
  for (std::size_t i = 1; i < 4; ++i) p[i] = p[i] + (s * s * r.uniform()) * Xy<double>{1, 1};
  return p;
}

struct Family {
  std::string name;
  std::function<Cubic(Source&)> make;
  double least_served;  // of all numerators, how many the filter knows at least
};

const Family FAMILIES[] = {
    {"uniform", [](Source& r) { return r.uniform_points(); }, 0.9999},
    {"small grid", [](Source& r) { return r.grid(2); }, 0.8},
    {"grid", [](Source& r) { return r.grid(64); }, 0.99},
    {"near-linear",
     [](Source& r) { return turned(scaled(r.uniform_points(), 1, r.power(-52, 0)), r.below(2) * r.uniform(3)); }, 0.75},
    {"near-circular", near_circular, 0.8},
    {"exact cusp", [](Source& r) { return cusp(r, true); }, 0.6},
    {"rounded cusp", [](Source& r) { return cusp(r, false); }, 0.6},
    {"loop",
     [](Source& r) {
       return Cubic{{{0, 0}, {2 + r.uniform(), 1}, {-1 + r.uniform(), 1}, {1, 0}}};
     },
     0.999},
    {"symmetric loop",
     [](Source& r) {
       return Cubic{{{0, 0}, {r.integer(9), 1}, {1 - r.integer(9), 1}, {1, 0}}};
     },
     0.9},
    {"inflection at an end", inflection_at_end, 0.75},
    {"nearly vertical at an end", nearly_vertical_at_end, 0.9},
    {"double point", double_point, 0.5},
    {"nearly level twice", nearly_level_twice, 0.99},
    {"nearly a cusp", nearly_cusp, 0.75},
    {"any scale",
     [](Source& r) {
       const double s = r.power(-300, 300);
       return scaled(r.uniform_points(), s, s * r.power(-20, 20));
     },
     0.3},
    {"huge and tiny", [](Source& r) { return scaled(r.uniform_points(), r.below(2) == 0 ? 1e300 : 1e-315, 1); }, 0.2},
    {"far from the origin",
     [](Source& r) {
       Cubic p = r.uniform_points();
       for (Xy<double>& q : p) q = q + Xy<double>{1e6, -1e9};
       return p;
     },
     0.99},
};

// The number of numerators that the filter knows the roots of.
int expect_same_roots(const Bezier_curve_2<double>& c) {
  const internal::Numerator_roots plain = internal::with_cut_numbers(
      c, [](const internal::Cut_numbers& numbers) { return internal::numerator_roots(numbers); });
  const internal::Cubic_roots filter(c);
  int known = 0;
  for (const internal::Numerator which : {SPEED_X, SPEED_Y, INFLECTION, CURVATURE_CHANGE})
    if (const std::optional<internal::Unit_roots> roots = filter(which)) {
      ++known;
      EXPECT_EQ(roots->is_zero, plain[which].is_zero);
      EXPECT_EQ(roots->roots, plain[which].roots) << which;
    }
  return known;
}

TEST(CubicRoots, AreThoseOfThePlainAlgorithm) {
  constexpr int ALL = 8000;
  const int COUNT = bounding_arcs_test::cases(bounding_arcs_test::FEW_CASES ? ALL / 4 : ALL);
  static_assert(ALL * (sizeof(FAMILIES) / sizeof(*FAMILIES)) >= 100000, "fewer curves show less");
  for (const Family& family : FAMILIES) {
    Source random;
    int known = 0;
    for (int i = 0; i < COUNT; ++i) {
      SCOPED_TRACE(family.name + ", curve " + std::to_string(i));
      known += expect_same_roots(curve(family.make(random)));
      if (HasFailure()) return;
    }
    const double share = known / (double(NUMERATOR_COUNT) * COUNT);
    EXPECT_GE(share, family.least_served) << family.name;
    RecordProperty(family.name, std::to_string(share));
  }
}

TEST(CubicRoots, OfBundledCurvesAreAllKnown) {
  for (const auto& file : std::filesystem::directory_iterator(BOUNDING_ARCS_EXAMPLE_DATA)) {
    if (file.path().extension() != ".json") continue;
    for (const Curve_record& record : read_curve_file(file.path().string()).curves)
      for (const auto& piece : record.bezier_pieces<double>()) EXPECT_EQ(expect_same_roots(piece), NUMERATOR_COUNT);
  }
}

// Quadratics, lines, and cubics with two level or upright legs, of the families above.
TEST(CubicRoots, OfLowerDegreesAndLevelLegsAreThoseOfThePlainAlgorithm) {
  const int COUNT = bounding_arcs_test::cases(500);
  for (const Family& family : FAMILIES) {
    Source random;
    for (int i = 0; i < COUNT; ++i) {
      SCOPED_TRACE(family.name + ", curve " + std::to_string(i));
      Cubic p = family.make(random);
      expect_same_roots(Bezier_curve_2<double>({p[0], p[1], p[2]}));
      EXPECT_EQ(expect_same_roots(Bezier_curve_2<double>({p[0], p[1]})), NUMERATOR_COUNT);
      p[random.below(2) == 0 ? 0 : 2].y = p[1].y;
      (random.below(2) == 0 ? p[3].y : p[2].x) = p[random.below(2) == 0 ? 1 : 2].y;
      expect_same_roots(curve(p));
      if (HasFailure()) return;
    }
  }
}

TEST(CubicRoots, OfQuadraticsAndLevelLegsAreKnown) {
  const auto known = [](const std::vector<Xy<double>>& p) { return expect_same_roots(Bezier_curve_2<double>(p)); };
  EXPECT_EQ(known({{0, 0}, {1, 2}, {3, 1}}), NUMERATOR_COUNT);
  EXPECT_EQ(known({{0, 0}, {2, 0}, {2, 3}}), NUMERATOR_COUNT);
  EXPECT_EQ(known({{0, 1}, {1, 1}, {2, 1}, {4, 5}}), NUMERATOR_COUNT);
  EXPECT_EQ(known({{0, 0}, {1, 2}, {1, 3}, {1, 7}}), NUMERATOR_COUNT);
}

TEST(CubicRoots, LeavesOtherDegreesAndWeightsAlone) {
  const Cubic p{{{0, 0}, {1, 2}, {3, 1}, {4, 5}}};
  EXPECT_FALSE(internal::Cubic_roots(Bezier_curve_2<double>({p[0], p[1], p[2], p[3], p[0]}))(SPEED_X).has_value());
  EXPECT_FALSE(internal::Cubic_roots(Bezier_curve_2<double>({p.begin(), p.end()}, {1, 2, 2, 1}))(SPEED_X).has_value());
}

}  // namespace
}  // namespace test_cubic_roots
