// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Hierarchy.h"

#include <CGAL/Bounding_arcs_2/number/Double_double.h>
#include <CGAL/Bounding_arcs_2/region/Arc_region_2.h>
#include "../library/verify/Thickness_proof.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bounding_arcs_tool {

std::unique_ptr<Segmented_curve> segment(const Curve_record& record, Kernel kernel) {
  switch (kernel) {
    case Kernel::DOUBLE:
      return detail::segment_double(record);
    case Kernel::FILTERED:
      return detail::segment_filtered(record);
    case Kernel::EXACT:
      break;
  }
  return detail::segment_exact(record);
}

namespace {

// How far a point is from a circle, in double-doubles: | |v|^2 - r^2 | / (|v| + r), v from the center.
double miss(const Xy<double>& p, const Output_circle& circle, double scale) {
  using Number = CGAL::Bounding_arcs::Double_double;
  const auto difference = [&](double a, double b) { return Number::two_sum(scale * a, -(scale * b)); };
  const Number x = difference(p.x, circle.center.x), y = difference(p.y, circle.center.y), r(scale * circle.radius);
  const Number power = x * x + y * y - r * r;
  return (std::fabs(power.hi) + power.err) / (2 * r.hi) / scale;
}

// Whether that is at most `most`, where long doubles decide it, as they do nearly always. An operation errs by eps/2 of
// its result, squares of differences by 3/2 eps, power by at most 3 eps of all squares; 8 eps cover the comparison,
// too, and what underflows where they do not.
std::optional<bool> is_near(const Xy<double>& p, const Output_circle& circle, double most) {
  using Number = long double;
  const Number x = Number(p.x) - circle.center.x, y = Number(p.y) - circle.center.y, r = circle.radius;
  const Number squares = x * x + y * y, power = std::fabs(squares - r * r), limit = 2 * r * Number(most);
  const Number slack = 8 * std::numeric_limits<Number>::epsilon() * (squares + r * r);
  if (!(slack >= std::numeric_limits<Number>::min())) return std::nullopt;
  if (power + slack <= limit) return true;
  if (power - slack > limit) return false;
  return std::nullopt;
}

double ulp_of_ends(const Arc_2& arc) {
  const double largest =
      std::max({std::fabs(arc.from.x), std::fabs(arc.from.y), std::fabs(arc.to.x), std::fabs(arc.to.y)});
  return CGAL::Bounding_arcs::ulp_of(largest);
}

namespace ba = CGAL::Bounding_arcs;

// The exact chain that points and bulges define.
ba::Boundary_chain_2<ba::Mpfr_interval> defined_chain(const Output_chain& pieces, mpfr_prec_t bits) {
  const auto number = [bits](double x) { return ba::Mpfr_interval(CGAL::Exact_rational(x), bits); };
  const auto point = [&](const Xy<double>& p) { return Xy<ba::Mpfr_interval>{number(p.x), number(p.y)}; };
  const auto piece = [&](const Arc_2& p) { return ba::piece_on_chord(point(p.from), point(p.to), number(p.bulge)); };
  // a piece of no length has no direction
  if (pieces.size() == 2 && pieces[0].from == pieces[0].to)
    return ba::Boundary_chain_2<ba::Mpfr_interval>(piece(pieces[1]));
  if (pieces.size() == 1 || pieces[1].from == pieces[1].to)
    return ba::Boundary_chain_2<ba::Mpfr_interval>(piece(pieces[0]));
  return {piece(pieces[0]), piece(pieces[1])};
}

}  // namespace

bool has_written_thickness(const Output_region& region, double end_error) {
  double ulp = 0, reach = 0;  // of the outer boundary from the start that it shares
  for (const auto* chain : {&region.inner, &region.outer})
    for (const Arc_2& piece : *chain) {
      if (!std::isfinite(piece.bulge) || !std::isfinite(ulp_of_ends(piece))) return false;
      ulp = std::max(ulp, ulp_of_ends(piece));
      if (chain == &region.outer)
        reach +=
            std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y) * std::max(1.0, std::fabs(piece.bulge));
    }
  constexpr double ALLOWED = 8;
  const CGAL::Exact_rational length =
      CGAL::Exact_rational(region.thickness) + CGAL::Exact_rational(ALLOWED * ulp + 2 * end_error);
  if (reach * (1 + 0x1p-40) <= ALLOWED * ulp) return true;
  const auto proves = [&](const Output_chain& inner, bool has_start, bool has_end, mpfr_prec_t bits) {
    const ba::Region_boundary_2<ba::Mpfr_interval> boundary{defined_chain(inner, bits),
                                                            defined_chain(region.outer, bits)};
    return ba::verify::Thickness_proof(boundary, ba::Mpfr_interval(length, bits), has_start, has_end).holds();
  };
  constexpr mpfr_prec_t FIRST = 128, LAST = 2048;
  for (mpfr_prec_t bits = FIRST; bits <= LAST; bits *= 4) {
    if (proves(region.inner, true, true, bits)) return true;
    if (region.inner.size() == 1) continue;
    // an inner piece of some ulp has the direction of its rounding; what is near enough to the other one does without
    // it
    if (proves({region.inner[0]}, true, false, bits) || proves({region.inner[1]}, false, true, bits)) return true;
  }
  return false;
}

std::optional<Output_circle> circle_of(const Arc_2& arc) {
  const double b = arc.bulge;
  if (b == 0) return std::nullopt;
  const Xy<double> chord = arc.to - arc.from;
  const Output_circle circle{arc.from + 0.5 * chord + ((1 - b) * (1 + b) / (4 * b)) * perp(chord),
                             std::hypot(chord.x, chord.y) * (1 + b * b) / (4 * std::fabs(b))};
  constexpr double MOST = 0x1p1000, ALLOWED = 4;  // ulp of the largest coordinate
  if (!(std::max({std::fabs(circle.center.x), std::fabs(circle.center.y), circle.radius}) <= MOST) ||
      !(circle.radius > 0))
    return std::nullopt;
  const double most = ALLOWED * ulp_of_ends(arc);
  const auto has = [&](const Xy<double>& end) {
    if (const std::optional<bool> decided = is_near(end, circle, most)) return *decided;
    const double scale = std::ldexp(1.0, -std::clamp(std::ilogb(circle.radius), -1000, 1000));
    return miss(end, circle, scale) <= most;
  };
  if (!has(arc.from) || !has(arc.to)) return std::nullopt;
  return circle;
}

const char* name_of(Method method) {
  static constexpr const char* NAMES[] = {"bca",       "sfa", "bilens",       "fat-arc",
                                          "fat-biarc", "box", "oriented-box", "hull"};
  return NAMES[static_cast<std::size_t>(method)];
}

const std::vector<Method>& all_methods() {
  static const std::vector<Method> METHODS{Method::BCA,       Method::SFA, Method::BILENS,       Method::FAT_ARC,
                                           Method::FAT_BIARC, Method::BOX, Method::ORIENTED_BOX, Method::HULL};
  return METHODS;
}

const char* name_of(Kernel kernel) {
  return kernel == Kernel::DOUBLE ? "double" : (kernel == Kernel::FILTERED ? "filtered" : "exact");
}

}  // namespace bounding_arcs_tool
