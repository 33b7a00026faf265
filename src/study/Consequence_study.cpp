// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Consequence_study.h.

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/study/Consequence_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>
#include "figure_errors.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace study {

using Spiral = Bezier_spiral_2<double>;

// Counts regions as a program does that halves what is not thin. \param is_thin of a part [t0, t1]
template <class Is_thin> [[nodiscard]] std::size_t count_regions(double t0, double t1, const Is_thin& is_thin) {
  constexpr std::size_t MOST = 64;  // a thickness that is no number never ends
  std::vector<std::pair<double, double>> parts{{t0, t1}};
  std::size_t count = 0;
  while (!parts.empty() && count + parts.size() < MOST) {
    const auto [from, to] = parts.back();
    parts.pop_back();
    const double middle = from + (to - from) / 2;
    if (is_thin(from, to) || middle == from || middle == to) {
      ++count;
      continue;
    }
    parts.push_back({from, middle});
    parts.push_back({middle, to});
  }
  return count + parts.size();
}

// Where the circle begins that a touching one becomes at a distance to the curve's left. \param end where they touch
[[nodiscard]] Xy<double> moved_by_center(const Circle_figure<double>& circle, const Xy<double>& end, double distance) {
  const Xy<double> out = end - circle.center;
  const double radius = dot(circle.normal, out) > 0 ? circle.radius + distance : circle.radius - distance;
  return circle.center + radius * unit_vector(out);
}
template <class NT>
[[nodiscard]] Xy<NT> moved_by_normal(const Circle_figure<NT>& circle, const Xy<NT>& end, double distance) {
  return end + NT(distance) * unit_vector(circle.normal);
}

// The places of the curve's start and end in offsets to the left and to the right.
template <class NT, class Move>
[[nodiscard]] std::vector<Xy<NT>> moved_ends(const Region_figures<NT>& figures, const Chord_frame_2<NT>& frame,
                                             double distance, const Move& move) {
  const bool is_start_first = figures.form == Region_form::BCA || frame.shape.tight_first;
  std::vector<Xy<NT>> moved;
  for (const bool is_start : {true, false})
    for (const double d : {distance, -distance})
      moved.push_back(move(figures.circles[is_start == is_start_first ? 0 : 1], is_start ? frame.p0 : frame.p1, d));
  return moved;
}

// \param exact places; enclosures far narrower than a double
[[nodiscard]] bool are_near(const std::vector<Xy<double>>& places, const std::vector<Xy<Mpfr_interval>>& exact,
                            double distance) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Xy<double>& p = places[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return false;
    const Xy<Mpfr_interval> off{Mpfr_interval(p.x) - exact[i].x, Mpfr_interval(p.y) - exact[i].y};
    if (!(dot(off, off).upper() <= distance * distance)) return false;
  }
  return true;
}

template <class Construction, class Textbook>
void add_consequences(const std::vector<Study_piece>& pieces, Region_form form, std::vector<Consequence_row>& rows) {
  constexpr double ULPS = 16 * 0x1p-52, SMALL = 0.01;
  Consequence_row row{pieces.front().family, pieces.front().delta, Construction::NAME};
  for (const Study_piece& piece : pieces) {
    const Spiral& spiral = piece.spiral;
    Enclosed_piece enclosed(spiral, piece.t0, piece.t1);
    if (Construction::NEEDS_CURVATURE && !enclosed.exact_shape().proper) continue;
    const auto exact = exact_figures<Construction>(enclosed);
    if (!exact || exact->form != form || exact->thickness.certain_sign() == 0) continue;
    ++row.pieces;
    const double thickness = exact->thickness.middle();
    const auto exact_frame = enclosed.frame(FIRST_PRECISION);
    const double chord = square_root(dot(exact_frame.shape.chord, exact_frame.shape.chord)).middle();
    const auto exact_ends = moved_ends(*exact, exact_frame, chord, moved_by_normal<Mpfr_interval>);
    const auto textbook_frame = [&](double t0, double t1) { return plain_frame(spiral.curve(), spiral, t0, t1); };
    const auto stable_frame = [&](double t0, double t1) { return spiral.frame<double>(t0, t1); };
    const std::size_t regions = count_regions(piece.t0, piece.t1, [&](double t0, double t1) {
      return bound_thickness<double, true>(Construction(), Piece_source<Spiral>{spiral, t0, t1}, SMALL * thickness)
          .within;
    });
    const auto look = [&](Consequences& c, const auto& frame_of, const auto& thickness_of, const auto& boundary_of,
                          const auto& move) {
      const Chord_frame_2<double> frame = frame_of(piece.t0, piece.t1);
      const double rounded = thickness_of(frame);
      for (int k = -3; k <= 2; ++k) {
        ++c.asked;
        c.wrong += (rounded <= thickness * std::exp2(k + 0.5)) == (k >= 0) ? 0u : 1u;
      }
      const double place =
          (std::max)({std::fabs(frame.p0.x), std::fabs(frame.p0.y), std::fabs(frame.p1.x), std::fabs(frame.p1.y)});
      const Region_boundary_2<double> boundary = boundary_of(frame);
      c.not_held += is_within(spiral, piece.t0, piece.t1, boundary, ULPS * place) ? 0u : 1u;
      const auto figures = region_figures(boundary, rounded, frame.shape.tight_first);
      c.torn += are_near(moved_ends(figures, frame, chord, move), exact_ends, ULPS * (place + chord)) ? 0u : 1u;
      const std::size_t count = count_regions(piece.t0, piece.t1, [&](double t0, double t1) {
        return thickness_of(frame_of(t0, t1)) <= SMALL * thickness;
      });
      c.miscounted += count == regions ? 0u : 1u;
    };
    look(
        row.textbook, textbook_frame, [](const auto& frame) { return Textbook::thickness(frame); },
        [](const auto& frame) { return Textbook::boundary(frame); },
        [](const auto& circle, const auto& end, double d) {
          return circle.is_line ? moved_by_normal(circle, end, d) : moved_by_center(circle, end, d);
        });
    look(
        row.stable, stable_frame, [](const auto& frame) { return Construction::thickness(frame.shape); },
        [](const auto& frame) { return Construction::boundary(frame); }, moved_by_normal<double>);
  }
  if (row.pieces > 0) rows.push_back(row);
}

}  // namespace study

std::vector<Consequence_row> consequence_rows(const std::vector<Study_piece>& pieces) {
  using namespace study;
  std::vector<Consequence_row> rows;
  add_consequences<Bca, Textbook_bca>(pieces, Region_form::BCA, rows);
  add_consequences<Spiral_fat_arc, Textbook_spiral_fat_arc>(pieces, Region_form::SPIRAL_FAT_ARC, rows);
  add_consequences<Bilens, Textbook_bilens>(pieces, Region_form::BILENS, rows);
  return rows;
}

}  // namespace CGAL::Bounding_arcs
