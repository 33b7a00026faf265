// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_units.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bounding_arcs_tool {
namespace {

constexpr double INCH = 25.4, AU = 149597870700e3, SURVEY_FOOT = 1200e3 / 3937;
// By their numbers.
constexpr double INSUNITS[] = {
    0,                            // none
    INCH,                         // inch
    12 * INCH,                    // foot
    63360 * INCH,                 // mile
    1,                            // mm
    10,                           // cm
    1e3,                          // m
    1e6,                          // km
    INCH / 1e6,                   // microinch
    INCH / 1e3,                   // mil
    36 * INCH,                    // yard
    1e-7,                         // angstrom
    1e-6,                         // nm
    1e-3,                         // micrometer
    1e2,                          // dm
    1e4,                          // dam
    1e5,                          // hm
    1e12,                         // Gm
    AU,                           // astronomical unit
    9460730472580800e3,           // light year
    3.0856775814913673e16 * 1e3,  // parsec, 648000 / pi astronomical units
    SURVEY_FOOT,                  // US survey foot
    SURVEY_FOOT / 12,             // US survey inch
    SURVEY_FOOT * 3,              // US survey yard
    SURVEY_FOOT * 5280,           // US survey mile
};

}  // namespace

double dxf_unit_in_mm(long long number) {
  return number >= 0 && number < static_cast<long long>(std::size(INSUNITS)) ? INSUNITS[number] : 0;
}

int dxf_number_of_unit(double in_mm) {
  constexpr double SAME = 1e-6;  // of its size: files write some seven digits, and a US survey foot is 2e-6 longer
  const auto is_it = [&](double unit) { return unit > 0 && std::fabs(unit - in_mm) <= SAME * unit; };
  const auto* const found = std::find_if(std::begin(INSUNITS), std::end(INSUNITS), is_it);
  return found == std::end(INSUNITS) ? 0 : static_cast<int>(found - std::begin(INSUNITS));
}

}  // namespace bounding_arcs_tool
