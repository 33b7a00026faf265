// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Degenerate curves through everything that the tool makes of them.  BOUNDING_ARCS_CURVES in the environment sets how many
// of each kind, BOUNDING_ARCS_SEED which, and BOUNDING_ARCS_EXACT how many of them go through the exact kernel: one in so many.

#include "Hierarchy.h"
#include "degenerate_curves.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <string>

#include <unistd.h>

namespace {

using namespace bounding_arcs_tool;
using bounding_arcs_test::Bezier;
using bounding_arcs_test::Degenerate_curves;
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
  out << "}\n  --method " << name_of(c.method) << " --split " << (c.split == Split::OPTIMAL ? "optimal" : "midpoint") << " --eps " << c.eps << '\n';
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

// A point of an arc, a share of its angle from its start; as a rational curve of degree 2 in half-angle tangents.
Point on_arc(const Output_piece& arc, double s) {
  const Point chord = arc.to - arc.from;
  const double angle = std::atan(arc.bulge), u = std::tan((2 * s - 1) * angle), b = arc.bulge;
  if (std::fabs(b) < 0x1p-1000) return arc.from + s * chord;  // its inverse is not finite
  // from the middle of the chord, in half chords: along (1 + b^2)/(2b) sin 2x, across (cos 2x (1 + b^2) - (1 - b^2)) / (2b)
  const double along = (1 + b * b) / b * u / (1 + u * u), across = (b * b - u * u) / (b * (1 + u * u));
  return 0.5 * (arc.from + arc.to) + along / 2 * chord - across / 2 * perp(chord);
}

// The distance of a point from an arc of at most a half turn, without its centre.
double distance(const Point& q, const Output_piece& arc) {
  const Point chord = arc.to - arc.from, v = q - 0.5 * (arc.from + arc.to);
  const double length = std::hypot(chord.x, chord.y), a = length / 2, b = std::fabs(arc.bulge);
  const double ends = (std::min)(std::hypot(q.x - arc.from.x, q.y - arc.from.y), std::hypot(q.x - arc.to.x, q.y - arc.to.y));
  if (length == 0) return ends;
  const double x = v.x * (chord.x / length) + v.y * (chord.y / length);
  const double y = (arc.bulge > 0 ? -1 : 1) * (v.y * (chord.x / length) - v.x * (chord.y / length));
  if ((1 - b * b) * (x + a) + 2 * b * y < 0 || (1 - b * b) * (x - a) - 2 * b * y > 0) return ends;
  const double f = b * ((x - a) * (x + a) + y * y) / a + (1 - b * b) * y, square = 1 + b * b;
  return std::fabs(2 * f / (square + std::sqrt((std::max)(0.0, square * square + 4 * b * f / a))));
}

double size(const Point& p) { return (std::max)(std::fabs(p.x), std::fabs(p.y)); }

Output_piece scaled(const Output_piece& p, double scale) { return {scale * p.from, scale * p.to, p.bulge}; }

// What is wrong with a region as it is written, empty if nothing is.
std::string fault(const Output_region& r, double eps) {
  double largest = 0;
  for (const auto* chain : {&r.inner, &r.outer}) {
    for (const Output_piece& p : *chain) {
      for (const double x : {p.from.x, p.from.y, p.to.x, p.to.y, p.bulge})
        if (!std::isfinite(x)) return "a number that is not finite";
      if (const auto circle = circle_of(p))
        for (const double x : {circle->center.x, circle->center.y, circle->radius})
          if (!std::isfinite(x)) return "a circle that is not finite";
      largest = (std::max)({largest, size(p.from), size(p.to)});
    }
    if (chain->size() == 2 && !((*chain)[0].to == (*chain)[1].from)) return "a chain with a gap";
  }
  if (!(r.inner.front().from == r.outer.front().from && r.inner.back().to == r.outer.back().to)) return "chains with different ends";
  if (!(r.thickness >= 0 && r.thickness <= eps) || std::signbit(r.thickness)) return "a thickness of " + std::to_string(r.thickness);
  const double scale = largest > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(largest), -1000, 1000)) : 1;  // squares stay in range
  for (const Output_piece& outer : r.outer) {
    const double allowed = 0x1p-1000 + r.thickness * scale * (1 + 0x1p-30) + 0x1p-48 * largest * scale;
    constexpr int SAMPLES = 8;
    for (int i = 0; i <= SAMPLES; ++i) {
      const Point q = on_arc(scaled(outer, scale), i / double(SAMPLES));
      double nearest = std::numeric_limits<double>::infinity();
      for (const Output_piece& inner : r.inner) nearest = (std::min)(nearest, distance(q, scaled(inner, scale)));
      if (!(nearest <= allowed)) return "boundaries " + std::to_string(nearest / (r.thickness * scale)) + " times its thickness apart";
    }
  }
  return "";
}

struct Outcome {
  bool is_refused = false;
  std::string fault;
  std::vector<double> breaks;
  std::size_t regions = 0, slivers = 0, uncertified = 0;
};

Outcome outcome(const Case& c, Kernel kernel) {
  constexpr std::size_t MOST = 20000;
  Outcome result;
  std::unique_ptr<Segmented_curve> segmented;
  try {
    segmented = segment(c.record, kernel);
  } catch (const std::invalid_argument&) {
    result.is_refused = true;
    return result;
  }
  const auto hierarchy = segmented->build(c.method, c.split, c.eps, MOST, {});
  if (hierarchy->status() != Status::COMPLETE) {
    result.is_refused = true;
    return result;
  }
  hierarchy->for_each_region([&](const Output_region& r) {
    result.breaks.insert(result.breaks.end(), {r.t0, r.t1});
    if (result.fault.empty()) result.fault = fault(r, c.eps);
  });
  const Verification proofs = hierarchy->verify({});
  result.regions = proofs.regions;
  result.slivers = proofs.slivers;
  if (!proofs.failed.empty() && result.fault.empty()) {
    std::ostringstream out;
    out.precision(17);
    out << "t [" << proofs.failed[0].t0 << ", " << proofs.failed[0].t1 << "]: " << proofs.failed[0].reason;
    result.fault = out.str();
  }
  if (kernel != Kernel::EXACT) {
    const Verification certified = hierarchy->verify_certified({});
    result.uncertified = certified.failed.size();
    constexpr double MOST_ULPS = 64;
    if (!(certified.widening_ulps <= MOST_ULPS) && result.fault.empty())
      result.fault = "certified with a widening of " + std::to_string(certified.widening_ulps) + " ulp";
  }
  return result;
}

class DegenerateFamilies : public testing::TestWithParam<Kind> {};

TEST_P(DegenerateFamilies, AreProvenOrRefused) {
  const std::size_t count = from_environment("BOUNDING_ARCS_CURVES", 40), one_in_exact = from_environment("BOUNDING_ARCS_EXACT", 4);
  const auto seed = static_cast<unsigned>(from_environment("BOUNDING_ARCS_SEED", 20261122));
  for (const int signal : {SIGABRT, SIGFPE, SIGSEGV}) std::signal(signal, tell_current);
  Degenerate_curves curves(seed + static_cast<unsigned>(GetParam()));
  std::size_t refused[3] = {}, runs[3] = {}, regions = 0, slivers = 0, uncertified = 0;
  std::map<std::string, std::size_t> faults;
  for (std::size_t i = 0; i < count; ++i) {
    const Case c = random_case(curves, GetParam());
    current = text(c);
    Outcome filtered;
    for (const Kernel kernel : {Kernel::DOUBLE, Kernel::FILTERED, Kernel::EXACT}) {
      if (kernel == Kernel::EXACT && i % one_in_exact != 0) continue;
      Outcome o;
      try {
        o = outcome(c, kernel);
      } catch (const std::exception& error) {
        o.fault = std::string("an exception: ") + error.what();
      }
      if (kernel == Kernel::FILTERED) filtered = o;
      if (kernel == Kernel::EXACT && o.fault.empty() && (o.breaks != filtered.breaks || o.is_refused != filtered.is_refused))
        o.fault = "other splits than with the filtered kernel";
      ++runs[static_cast<int>(kernel)];
      refused[static_cast<int>(kernel)] += o.is_refused;
      regions += o.regions;
      slivers += o.slivers;
      uncertified += o.uncertified;
      if (o.fault.empty()) continue;
      const std::string what = o.fault.substr(0, o.fault.find_first_of("0123456789[")) ;
      if (faults[what]++ < 3) ADD_FAILURE() << current << "  --kernel " << name_of(kernel) << ": " << o.fault;
    }
  }
  for (const auto& f : faults) std::cout << f.second << " times " << f.first << '\n';
  std::cout << name(GetParam()) << ": " << count << " curves, " << regions << " regions, " << slivers << " slivers, " << uncertified
            << " without certificate, refused " << refused[0] << " of " << runs[0] << " double, " << refused[1] << " filtered, " << refused[2]
            << " of " << runs[2] << " exact\n";
}

INSTANTIATE_TEST_SUITE_P(Kinds, DegenerateFamilies, testing::ValuesIn(bounding_arcs_test::ALL_KINDS),
                         [](const auto& info) { return name(info.param); });

}  // namespace
