// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of study/Consequence_study.h.

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/study/Consequence_study.h>
#include <CGAL/Bounding_arcs_2/study/Textbook.h>
#include <CGAL/Bounding_arcs_2/study/internal/figure_errors.h>
#include <CGAL/Bounding_arcs_2/study/internal/plain_frame.h>
#include <CGAL/Bounding_arcs_2/tree/Piece_source.h>
#include <CGAL/Bounding_arcs_2/verify/outside_bound.h>

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
    const auto textbook_frame = [&](double t0, double t1) { return plain_frame(spiral.curve(), spiral, t0, t1); };
    const auto stable_frame = [&](double t0, double t1) { return spiral.frame<double>(t0, t1); };
    const std::size_t regions = count_regions(piece.t0, piece.t1, [&](double t0, double t1) {
      return bound_thickness<double, true>(Construction(), Piece_source<Spiral>{spiral, t0, t1}, SMALL * thickness)
          .within;
    });
    const auto look = [&](Consequences& c, const auto& frame_of, const auto& thickness_of, const auto& boundary_of) {
      const Chord_frame_2<double> frame = frame_of(piece.t0, piece.t1);
      const double rounded = thickness_of(frame);
      for (int k = -3; k <= 2; ++k) {
        ++c.asked;
        c.wrong += (rounded <= thickness * std::exp2(k + 0.5)) == (k >= 0) ? 0u : 1u;
      }
      const double place =
          (std::max)({std::fabs(frame.p0.x), std::fabs(frame.p0.y), std::fabs(frame.p1.x), std::fabs(frame.p1.y)});
      c.not_held += is_within(spiral, piece.t0, piece.t1, boundary_of(frame), ULPS * place) ? 0u : 1u;
      const std::size_t count = count_regions(piece.t0, piece.t1, [&](double t0, double t1) {
        return thickness_of(frame_of(t0, t1)) <= SMALL * thickness;
      });
      c.miscounted += count == regions ? 0u : 1u;
    };
    look(
        row.textbook, textbook_frame, [](const auto& frame) { return Textbook::thickness(frame); },
        [](const auto& frame) { return Textbook::boundary(frame); });
    look(
        row.stable, stable_frame, [](const auto& frame) { return Construction::thickness(frame.shape); },
        [](const auto& frame) { return Construction::boundary(frame); });
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
