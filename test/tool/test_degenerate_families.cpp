// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Degenerate curves through everything that the tool makes of them.  BOUNDING_ARCS_CURVES in the environment sets how
// many of each kind, BOUNDING_ARCS_SEED which, and BOUNDING_ARCS_EXACT how many of them go through the exact kernel:
// one in so many.

#include "Hierarchy.h"
#include "bulge_arcs.h"
#include "cases.h"
#include "degenerate_curves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

namespace test_degenerate_families {
namespace {

using namespace bounding_arcs_tool;
using bounding_arcs_test::Bezier;
using bounding_arcs_test::Degenerate_curves;
using bounding_arcs_test::FEW_CASES;
using bounding_arcs_test::Kind;
using bounding_arcs_test::Point;

std::size_t from_environment(const char* name, std::size_t otherwise) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoul(text, nullptr, 10) : otherwise;
}

// What a signal would otherwise take with it.
std::string current;
void tell_current(int signal) {
  const char* line = current.c_str();
  static_cast<void>(!::write(STDERR_FILENO, line, std::strlen(line)));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

struct Case {
  Curve_record record;
  bool may_be_refused = false;  // by the double kernel
  Method method;
  Split split;
  double eps;
};

std::string text(const Case& c) {
  std::ostringstream out;
  out.precision(17);
  out << "{\"type\":\"bezier\",\"degree\":" << c.record.degree << ",\"control_points\":[";
  const char* separator = "";
  for (const Point& p : c.record.control_points) {
    out << separator << '[' << p.x << ',' << p.y << ']';
    separator = ",";
  }
  out << ']';
  separator = ",\"weights\":[";
  for (const double w : c.record.weights) {
    out << separator << w;
    separator = ",";
  }
  if (!c.record.weights.empty()) out << ']';
  out << "}\n  --method " << name_of(c.method) << " --split " << (c.split == Split::OPTIMAL ? "optimal" : "midpoint")
      << " --eps " << c.eps << '\n';
  return out.str();
}

Case random_case(Degenerate_curves& curves, Kind kind) {
  const Bezier curve = curves(kind);
  Case c;
  c.record.degree = curve.degree();
  c.record.control_points = curve.control_points();
  c.record.weights = curve.weights();
  c.eps = curves.eps(curve);
  c.method = static_cast<Method>(curves.below(3));
  c.split = static_cast<Split>(curves.below(4) == 0);
  return c;
}

double size(const Point& p) { return (std::max)(std::fabs(p.x), std::fabs(p.y)); }

Arc_2 scaled(const Arc_2& p, double scale) { return {scale * p.from, scale * p.to, p.bulge}; }

// What is wrong with a region as it is written, empty if nothing is.
std::string fault(const Output_region& r, double eps, double coordinates) {
  double largest = coordinates;
  for (const auto* chain : {&r.inner, &r.outer}) {
    for (const Arc_2& p : *chain) {
      for (const double x : {p.from.x, p.from.y, p.to.x, p.to.y, p.bulge})
        if (!std::isfinite(x)) return "a number that is not finite";
      if (const auto circle = circle_of(p))
        for (const double x : {circle->center.x, circle->center.y, circle->radius})
          if (!std::isfinite(x)) return "a circle that is not finite";
      largest = (std::max)({largest, size(p.from), size(p.to)});
    }
    if (chain->size() == 2 && !((*chain)[0].to == (*chain)[1].from)) return "a chain with a gap";
  }
  if (!(r.inner.front().from == r.outer.front().from && r.inner.back().to == r.outer.back().to))
    return "chains with different ends";
  if (!(r.thickness >= 0 && r.thickness <= eps) || std::signbit(r.thickness))
    return "a thickness of " + std::to_string(r.thickness);
  const double scale =
      largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;  // squares stay in range
  for (const Arc_2& outer : r.outer) {
    const double allowed = 0x1p-1000 + r.thickness * scale * (1 + 0x1p-30) + 0x1p-48 * largest * scale;
    constexpr int SAMPLES = 8;
    for (int i = 0; i <= SAMPLES; ++i) {
      const Point q = bounding_arcs_test::point_on(scaled(outer, scale), i / double(SAMPLES));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Arc_2& inner : r.inner)
        nearest = (std::min)(nearest, bounding_arcs_test::distance_from(scaled(inner, scale), q));
      if (!(nearest <= allowed))
        return "boundaries " + std::to_string(nearest / (r.thickness * scale)) + " times its thickness apart";
    }
  }
  return "";
}

std::string place(const Unproven_region& r) {
  std::ostringstream out;
  out.precision(17);
  out << r.reason << ", t [" << r.t0 << ", " << r.t1 << ']';
  return out.str();
}

struct Outcome {
  bool is_refused = false;
  std::string fault;
  std::vector<double> breaks;
  std::size_t regions = 0, slivers = 0, uncertified = 0;
  std::string without_certificate;  // the first such region
};

// What a kernel makes of a curve, and, when asked for, its proofs.
class Run {
 public:
  Run(const Case& c, Kernel kernel) : kernel_(kernel), eps_(c.eps) {
    constexpr std::size_t MOST = 20000;
    try {
      segmented_ = segment(c.record, kernel);
    } catch (const std::invalid_argument&) {
      outcome.is_refused = true;
      return;
    }
    hierarchy_ = segmented_->build(c.method, c.split, c.eps, MOST, {});
    if (hierarchy_->status() != Status::COMPLETE) {
      outcome.is_refused = true;
      return;
    }
    double coordinates = 0;
    for (const Point& p : c.record.control_points) coordinates = (std::max)(coordinates, size(p));
    hierarchy_->for_each_region([&](const Output_region& r) {
      outcome.breaks.insert(outcome.breaks.end(), {r.t0, r.t1});
      if (outcome.fault.empty()) outcome.fault = fault(r, c.eps, coordinates);
    });
  }

  void prove() {
    if (outcome.is_refused) return;
    const Verification proofs = hierarchy_->verify({});
    outcome.regions = proofs.regions;
    outcome.slivers = proofs.slivers;
    if (!proofs.failed.empty() && outcome.fault.empty()) outcome.fault = place(proofs.failed[0]);
    if (kernel_ == Kernel::EXACT) return;
    const Verification certified = hierarchy_->verify_certified({});
    outcome.uncertified = certified.failed.size();
    if (outcome.uncertified > 0) outcome.without_certificate = place(certified.failed[0]);
    for (const Unproven_region& r : certified.failed)  // no widening was told, or a wrong one
      if (r.reason.rfind("no region is proven", 0) != 0 && outcome.fault.empty()) outcome.fault = place(r);
    hierarchy_->for_each_certified_region([&](const Output_region& r) {
      if (!(r.thickness <= eps_) && outcome.fault.empty()) outcome.fault = "a certified region thicker than eps";
    });
    constexpr double MOST_ULPS = 64;
    if (!(certified.widening_ulps <= MOST_ULPS) && outcome.fault.empty())
      outcome.fault = "certified with a widening of " + std::to_string(certified.widening_ulps) + " ulp";
  }

  Outcome outcome;

 private:
  Kernel kernel_;
  double eps_;
  std::unique_ptr<Segmented_curve> segmented_;
  std::unique_ptr<Curve_hierarchy> hierarchy_;
};

Outcome outcome(const Case& c, Kernel kernel) {
  Run run(c, kernel);
  run.prove();
  return run.outcome;
}

// Of double, filtered and, where asked for, exact.  The exact regions of equal pieces are one thing, whose proofs are
// most of the time: where double and filtered have the same pieces, they are proven for one of them.
std::vector<Outcome> outcomes(const Case& c, Kernel proven, bool with_exact) {
  Run runs[] = {{c, Kernel::DOUBLE}, {c, Kernel::FILTERED}};
  const bool are_equal = runs[0].outcome.breaks == runs[1].outcome.breaks;
  for (const Kernel kernel : {Kernel::DOUBLE, Kernel::FILTERED})
    if (!are_equal || kernel == proven) runs[static_cast<int>(kernel)].prove();
  std::vector<Outcome> result{runs[0].outcome, runs[1].outcome};
  if (!with_exact) return result;
  result.push_back(outcome(c, Kernel::EXACT));
  Outcome& exact = result.back();
  const bool is_same = exact.breaks == result[1].breaks && exact.is_refused == result[1].is_refused;
  if (exact.fault.empty() && !is_same) exact.fault = "other splits than with the filtered kernel";
  return result;
}

class DegenerateFamilies : public testing::TestWithParam<Kind> {};

TEST_P(DegenerateFamilies, AreProvenOrRefused) {
  const std::size_t count = from_environment("BOUNDING_ARCS_CURVES", 25),
                    one_in_exact = from_environment("BOUNDING_ARCS_EXACT", 4);
  const auto seed = static_cast<unsigned>(from_environment("BOUNDING_ARCS_SEED", 20261122));
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV}) std::signal(signal, tell_current);
  Degenerate_curves curves(seed + static_cast<unsigned>(GetParam()));
  std::size_t refused[3] = {}, runs[3] = {}, regions = 0, slivers = 0, uncertified = 0;
  std::map<std::string, std::size_t> faults;
  for (std::size_t i = 0; i < count; ++i) {
    const Case c = random_case(curves, GetParam());
    current = text(c);
    std::vector<Outcome> all;
    try {
      all = outcomes(c, i % 2 == 0 ? Kernel::DOUBLE : Kernel::FILTERED, i % one_in_exact == 0);
    } catch (const std::exception& error) {
      all.resize(1);
      all[0].fault = std::string("an exception: ") + error.what();
    }
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Outcome& o = all[k];
      ++runs[k];
      refused[k] += o.is_refused;
      regions += o.regions;
      slivers += o.slivers;
      const char* kernel = name_of(static_cast<Kernel>(k));
      if (o.uncertified > 0 && uncertified == 0)
        std::cout << "for example: " << current << "  --certified --kernel " << kernel << ": " << o.without_certificate
                  << '\n';
      uncertified += o.uncertified;
      if (o.fault.empty()) continue;
      const std::string what = o.fault.substr(0, o.fault.find_first_of("0123456789"));
      if (faults[what]++ < 3) ADD_FAILURE() << current << "  --kernel " << kernel << ": " << o.fault;
    }
  }
  for (const auto& f : faults) std::cout << f.second << " times " << f.first << '\n';
  std::cout << name(GetParam()) << ": " << count << " curves, " << regions << " regions, " << slivers << " slivers, "
            << uncertified << " without certificate, refused " << refused[0] << " of " << runs[0] << " double, "
            << refused[1] << " filtered, " << refused[2] << " of " << runs[2] << " exact\n";
}

Case known_case(std::vector<Point> points, double eps, std::vector<double> weights = {}) {
  Case c;
  c.record.degree = static_cast<int>(points.size()) - 1;
  c.record.control_points = std::move(points);
  c.record.weights = std::move(weights);
  c.eps = eps;
  return c;
}

// Of curves that are this thin double may not reach eps.
Case thin_case(std::vector<Point> points, double eps) {
  Case c = known_case(std::move(points), eps);
  c.may_be_refused = true;
  return c;
}

// Each has met an abort, a wrong thickness, splits that differ between kernels, or a proof that failed.
std::vector<Case> known_cases() {
  return {
      known_case({{0, 0}, {1, 1}, {0, 0}, {1, 1}}, 0.1),            // turns where C'' = 0, too
      known_case({{0, 0}, {1, 3}, {-2, 1}, {1, 3}, {0, 0}}, 1e-3),  // folds on itself
      known_case({{1.5, 0.25}, {1.5, -1}, {1, 2}, {2, -1.3}, {1, 2}, {1.5, -1}, {1.5, 0.25}}, 0.004),
      known_case({{1.5, 0.25}, {1.5, -1}, {1, 2}, {2, -1.3}, {1, 2}, {1.5, -1}, {1.5, 0.25}}, 0.1),
      known_case({{1e110, 3}, {-1e110, 3}, {1e110, 2}}, 1e110),
      known_case({{0, 0}, {1, 1}}, 0.1),
      known_case({{0.39136, 0.16592}, {0.47591, 0.20177}, {-0.27258, -0.11556}, {-0.54603, -0.23149}}, 0.1),
      known_case({{0, 0}, {1e160, 0}, {1e160, 1e160}}, 1e159),
      known_case({{0, 0}, {1e-170, 0}, {1e-170, 1e-170}}, 1e-171),
      known_case({{1e300, -6.93}, {1, 1e-8}, {4.9e-324, 3}}, 3.16e299, {3, 1, 1}),
      known_case({{0.5, 0.2}, {-0.2, -0.7}, {0.4, -0.2}, {0.7, -1}}, 0.1, {1e6, 1, 1e-6, 1e6}),
      known_case({{0, 0}, {1e6, 0}, {-3e5, 1}}, 1e5),
      known_case({{0, 0}, {1e-9, 0}, {0.999999999, 1e-9}, {1, 0}}, 1e-3),   // a certified BCA as thick as 0.05
      known_case({{0, 0}, {1, 3}, {4, 3}, {3, 0}}, 0.004, {1, 1e9, 1, 1}),  // a right widening that was not proven
      // so thin that squares of short tangents leave the range of double
      thin_case({{-1.0638920332083204e+219, 1.3380469987499755e+44},
                 {-1.0638920332083204e+219, -2.0070704981249633e+44},
                 {-1.0638920332083204e+219, 1.3380469987499755e+44},
                 {1.5958380498124805e+219, 1.3380469987499755e+44}},
                4.9858904026739285e+218),
      thin_case({{-1.0663559452032081e-102, -3.2595388292155846e+143},
                 {7.4644916164224575e-102, 1.3038155316862339e+143},
                 {0, -3.2595388292155846e+143},
                 {-4.2654237808128325e-102, 1.3038155316862339e+143}},
                3.8792973206234251e+142),
      thin_case({{6.1567270285135832e+190, 3.9728939162956661e-28},
                 {-6.1567270285135832e+190, 2.3837363497773999e-27},
                 {6.1567270285135832e+190, -2.7810257414069664e-27},
                 {-6.1567270285135832e+190, 1.986446958147833e-27}},
                4.0763240789537618e+190),
      // products of errors that are lost over divisors as small
      thin_case({{-8.8868016322798541e-70, -8.9487046501594928e+182},
                 {-8.1396984878659901e-70, 1.103855485112453e+183},
                 {2.3068713397579581e-69, -4.8854011209191207e+182},
                 {-3.0937476467388356e-69, 2.1530084087778234e+182},
                 {-1.4048191509386351e-69, 4.8899095440402229e+182},
                 {-2.933990930877265e-69, 9.9021035476644719e+182}},
                1.3456375956733359e+181),
      // almost folds, where C' is some ulp of what it is nearby
      known_case({{2, 0.25},
                  {2, 0.67857142857142849},
                  {-0.1428571428571429, 0.75},
                  {0.28571428571428559, 1.1785714285714286},
                  {0.28571428571428564, 1.1785714285714284},
                  {-0.1428571428571429, 0.75},
                  {2, 0.6785714285714286},
                  {2, 0.25}},
                 0.85650239033375009),
      known_case({{1.75, -0.25},
                  {-0.3928571428571429, 0.3928571428571429},
                  {-0.75, -0.035714285714285726},
                  {-1.3214285714285714, 0.46428571428571425},
                  {-1.3214285714285714, 0.46428571428571425},
                  {-0.75, -0.035714285714285726},
                  {-0.39285714285714268, 0.39285714285714279},
                  {1.75, -0.25}},
                 0.88210416827793292),
      known_case({{0.27774334149415347, 0.67717287881118526},
                  {0.72648746853474633, -0.032661752148941764},
                  {0.41470770267348672, -0.77046873166504803},
                  {0.50898738725499892, -0.95815592357824186},
                  {0.44638399958600955, -1.0787388501832931},
                  {0.47998157773040839, -0.96760866405755408},
                  {0.50440447579936931, -0.6009198637714086}},
                 0.055471944026426419),
      // cusps and folds at parameters that are no doubles, of several orders
      known_case({{0, 0}, {-1, 0}, {1, 0}, {0, 27}}, 0.01),
      known_case({{0, 0}, {2, 2}, {1, 1}}, 0.1),
      known_case({{0, 0}, {0, 0}, {0, 0}, {1, 1}, {3, 2}}, 0.01),
      // a line but for an ulp, whose outer boundary starts at a right angle to the end of the inner one
      known_case({{26.224357532038397, -12.112178766019197},
                  {25.474357532038397, -12.1121787660192},
                  {24.224357532038397, -12.112178766019197},
                  {24.224357532038397, -12.1121787660192}},
                 0.015486042731014829),
      // folds of a curve and a tolerance that are less than an ulp of the coordinates
      known_case(
          {{-2.1506640250437876e+173, -9.170195124625806e+68},
           {-2.1506640250437876e+173, -1.200626863304217e+69},
           {-2.150664025043787e+173, 1.8475507324170086e+69},
           {-2.1506640250437881e+173, 3.3655817969565705e+69},
           {-2.1506640250437876e+173, 2.2925487814062016e+69}},
          9.4769444835538785e+155,
          {3.5297415046293565, 1.2775417134170834, 0.79607752601168302, 1.0242569975132749, 0.90098818302197925}),
  };
}

TEST(DegenerateCurves, ThatBrokeOnceAreProven) {
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV}) std::signal(signal, tell_current);
  std::size_t turn = 0;
  for (Case c : known_cases()) {
    ++turn;
    for (const Method method : {Method::BCA, Method::SFA, Method::BILENS}) {
      if (FEW_CASES && static_cast<std::size_t>(method) != turn % 3) continue;
      for (const Split split : {Split::MIDPOINT, Split::OPTIMAL}) {
        if (FEW_CASES && split == Split::OPTIMAL) break;
        c.method = method;
        c.split = split;
        current = text(c);
        const std::vector<Outcome> all =
            outcomes(c, split == Split::MIDPOINT ? Kernel::DOUBLE : Kernel::FILTERED, true);
        for (const Kernel kernel : {Kernel::DOUBLE, Kernel::FILTERED, Kernel::EXACT}) {
          const Outcome& o = all[static_cast<std::size_t>(kernel)];
          EXPECT_EQ(o.fault, "") << current << "  --kernel " << name_of(kernel);
          EXPECT_FALSE(o.is_refused && !(c.may_be_refused && kernel == Kernel::DOUBLE))
              << current << "  --kernel " << name_of(kernel);
          EXPECT_EQ(o.uncertified, 0u) << current << "  --kernel " << name_of(kernel) << ": " << o.without_certificate;
        }
        EXPECT_EQ(all[2].breaks, all[1].breaks) << current;
      }
    }
  }
}

TEST(DegenerateCurves, OutOfRangeAreRefused) {
  for (const Case& c : {known_case({{0, 0}, {1, 1e-305}, {2, 0}}, 0.1),
                        known_case({{0.5, 0.2}, {-0.2, -0.7}, {0.4, -0.2}, {0.7, -1}}, 0.1, {1e60, 1, 1e-60, 1e60}),
                        known_case({{0, 0}, {1e305, 0}, {0, 1e305}}, 1e304)})
    for (const Kernel kernel : {Kernel::DOUBLE, Kernel::FILTERED, Kernel::EXACT})
      EXPECT_THROW(segment(c.record, kernel), std::invalid_argument);
}

TEST(DegenerateCurves, LinesAreOneRegionOfNoThickness) {
  Case c = known_case({{0, 0}, {1, 1}}, 0.1);
  for (const Method method : {Method::BCA, Method::SFA, Method::BILENS})
    for (const Split split : {Split::MIDPOINT, Split::OPTIMAL})
      for (const Kernel kernel : {Kernel::DOUBLE, Kernel::FILTERED, Kernel::EXACT}) {
        std::size_t regions = 0;
        const auto segmented = segment(c.record, kernel);
        segmented->build(method, split, c.eps, 1000, {})->for_each_region([&](const Output_region& r) {
          ++regions;
          EXPECT_EQ(r.thickness, 0);
        });
        EXPECT_EQ(regions, 1u) << name_of(kernel) << ' ' << name_of(method);
      }
}

INSTANTIATE_TEST_SUITE_P(Kinds, DegenerateFamilies, testing::ValuesIn(bounding_arcs_test::ALL_KINDS),
                         [](const auto& info) { return name(info.param); });

}  // namespace
}  // namespace test_degenerate_families
