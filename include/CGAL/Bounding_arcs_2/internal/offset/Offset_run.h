// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One offset of some chains: which sides are offset, the raw offset, its trimming, and once more with distances that
// are a little different where that does not fit together.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_OFFSET_OFFSET_RUN_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_OFFSET_OFFSET_RUN_H

#include <CGAL/Bounding_arcs_2/internal/offset/Cover.h>
#include <CGAL/Bounding_arcs_2/internal/offset/Raw_offset.h>
#include <CGAL/Bounding_arcs_2/internal/offset/Trimmer.h>
#include <CGAL/Bounding_arcs_2/internal/offset/offset_chains.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Offset_run {
 public:
  Offset_run(const Source_arcs& sources, const Offset_options& options, double d)
      : sources_(sources), options_(options), distance_(d), is_simple_(sources.is_simple()) {
    for (const Source_curve& c : sources.curves) {
      curves_ = (std::max)(curves_, c.curve + 1);
      has_open_ = has_open_ || !c.is_closed;
      has_closed_ = has_closed_ || c.is_closed;
    }
    is_round_ = options.join == Offset_join::ROUND && (options.cap == Offset_cap::ROUND || !has_open_);
  }

  /// Appends the chains, and takes the error and the status into account.
  void add_to(Offset& offset) {
    constexpr int ATTEMPTS = 8;
    for (int k = 0; k < ATTEMPTS; ++k)
      if (attempt(k, k + 1 == ATTEMPTS, offset)) return;
    offset.status = Offset_status::UNRESOLVED;
  }

 private:
  struct Sides {
    bool left, right;
  };

  // Distances of the curves.  At first d; then up to eps / 8 more or less, another one for each curve, so that curves
  // that coincide have offsets that do not.
  [[nodiscard]] std::vector<double> distances(int attempt) const {
    std::vector<double> result(curves_, std::fabs(distance_));
    if (attempt == 0) return result;
    constexpr double LARGEST = 0x1p-3, GOLDEN = 0.6180339887498949;
    const double size = LARGEST * options_.eps * attempt / 8 * (attempt % 2 == 0 ? -1 : 1);
    for (std::size_t c = 0; c < curves_; ++c) {
      const double share = GOLDEN * static_cast<double>(c + 1);
      result[c] = (std::max)(0.0, result[c] + size * (0.5 + (share - std::floor(share)) / 2));
    }
    return result;
  }

  bool attempt(int number, bool is_last, Offset& offset) {
    constexpr double OF_SNAPPING = 0x1p-13, OF_LINKS = 0x1p-5;
    const std::vector<double> d = distances(number);
    const double room = sources_.room(distance_);
    Raw_builder builder(sources_, options_, OF_SNAPPING * options_.eps);
    for (const Source_curve& c : sources_.curves) {
      if (!c.is_closed) {
        builder.add_band(c, d[c.curve]);
        continue;
      }
      const Sides sides = sides_of(c);
      if (sides.left) builder.add_side(c, false, d[c.curve]);
      if (sides.right) builder.add_side(c, true, d[c.curve]);
    }
    const Raw_offset& raw = builder.result();
    const Cover cover(sources_, d, raw.shapes, is_round_);
    Trimmer trimmer(raw, cover, room, OF_LINKS * options_.eps);
    if (is_last) trimmer.let_overlaps_pass();
    const bool fits = trimmer.trim();
    if (!fits && !is_last) return false;
    double moved = 0;
    for (const double x : d) moved = (std::max)(moved, std::fabs(x - std::fabs(distance_)));
    offset.error = (std::max)(offset.error, moved + 4 * raw.gap + room + (fits ? 0 : OF_LINKS * options_.eps));
    add_chains(trimmer.loops(), raw, offset);
    return fits;
  }

  [[nodiscard]] bool is_inside(int winding) const {
    return options_.rule == Fill_rule::NONZERO ? winding != 0 : winding % 2 != 0;
  }
  // Which sides of a closed curve the offset may be on: of curves that do not cross, one.
  [[nodiscard]] Sides sides_of(const Source_curve& c) const {
    if (!is_simple_) return {true, true};
    int around = c.area > 0 ? 0 : -1;  // on the right
    for (const Source_curve& other : sources_.curves)
      if (&other != &c) around += sources_.winding(other, c.start);
    const bool wanted = distance_ < 0;
    return {is_inside(around + 1) == wanted, is_inside(around) == wanted};
  }
  // Whether a loop bounds what is asked for: it is outside of closed curves, or inside, all of it.
  [[nodiscard]] bool is_wanted(const Raw_loop& loop) const {
    if (!has_closed_ || (is_simple_ && !has_open_)) return true;
    const Raw_part& p = loop[loop.size() / 2];
    return is_inside(sources_.winding(moebius_point(p.arc, 0.5))) == (distance_ < 0);
  }

  void add_chains(const std::vector<Raw_loop>& loops, const Raw_offset& raw, Offset& offset) const {
    const std::size_t first = offset.chains.size();
    const bool is_band = !has_closed_ || distance_ > 0;  // what is asked for is on the right of loops
    for (const Raw_loop& loop : loops) {
      if (!is_wanted(loop)) continue;
      if (!has_closed_ && options_.side != Offset_side::BOTH) {
        add_one_side(loop, raw, sources_, options_.side == Offset_side::LEFT, offset.chains);
        continue;
      }
      Offset_chain chain;
      for (const Raw_part& p : loop) chain.pieces.push_back(piece_of(p, raw, sources_));
      if (is_band) reverse(chain.pieces);
      const Chain_size size = size_of(chain.pieces);
      // thinner than that and it is not there at a distance within eps
      constexpr double VANISHES = 0x1p-4;
      if (2 * std::fabs(size.area) <= VANISHES * options_.eps * size.length) continue;
      chain.area = size.area;
      chain.is_ccw = size.area > 0;
      offset.chains.push_back(std::move(chain));
    }
    nest(offset.chains, first);
  }

  const Source_arcs& sources_;
  const Offset_options& options_;
  double distance_;
  bool is_simple_, is_round_ = true, has_open_ = false, has_closed_ = false;
  std::uint32_t curves_ = 0;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
