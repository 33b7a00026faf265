// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One offset of some chains: which sides are offset, the raw offset, and its trimming, which leaves no
// self-intersection.  Trimmer.h trims by the signs of crossings, Tolerant_trimmer.h where rounding decides signs.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_RUN_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_RUN_H

#include <CGAL/Bounding_arcs_2/offset/internal/Offset_job.h>
#include <CGAL/Bounding_arcs_2/tree/Box_tree.h>
#include "Cover.h"
#include "Raw_offset.h"
#include "Tolerant_trimmer.h"
#include "Trimmer.h"
#include "blunt_cusps.h"
#include "drop_covered.h"
#include "offset_chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Offset_run {
 public:
  Offset_run(const Source_arcs& sources, const Offset_job& job, double d)
      : sources_(sources), job_(job), distance_(d), eps_((std::min)(job.eps, sources.least_eps())),
        is_simple_(sources.is_simple() && job.side == Offset_side::BOTH) {
    for (const Source_curve& c : sources.curves) {
      has_open_ = has_open_ || !c.is_closed;
      if (is_thin(c)) is_simple_ = false;
      has_closed_ = has_closed_ || (c.is_closed && job.side == Offset_side::BOTH);  // one side is that of a band
    }
    is_simple_ = is_simple_ && !(has_open_ && has_closed_);  // bands end at offsets inside what encloses them
    is_round_ = job.join == Offset_join::ROUND && (job.cap == Offset_cap::ROUND || !has_open_);
    // normals of one curve may reach through another, beyond its side that is not offset
    if (!is_round_ && sources.curves.size() > 1) is_simple_ = false;
  }

  /// Appends the chains, and takes the error and the status into account.
  void add_to(Offset& offset) {
    for (const Source_curve& c : sources_.curves) sides_.push_back(sides_of(c));
    const std::size_t first = offset.chains.size();
    for (const std::vector<std::uint32_t>& group : groups()) add_group(group, offset);
    nest(offset.chains, first);
  }

 private:
  // Curves whose offsets may meet are in one group, so that what is made on the way is never that of all curves.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> groups() const {
    const auto count = static_cast<std::uint32_t>(sources_.curves.size());
    std::vector<std::uint32_t> all(count);
    std::iota(all.begin(), all.end(), 0U);
    if (!is_round_) return {all};  // what is covered has shapes of its own, and miters reach farther
    // edges are moved by less than the gap that is let pass in front of them
    const double d = std::fabs(distance_), reach = d + eps_ + 4 * std::sqrt(sources_.room(d) * d);
    std::vector<CGAL::Bbox_2> boxes;
    for (const Source_curve& c : sources_.curves)
      boxes.emplace_back(c.box.xmin() - reach, c.box.ymin() - reach, c.box.xmax() + reach, c.box.ymax() + reach);
    std::vector<std::uint32_t> first = all;  // of the group, over others of it
    const auto first_of = [&](std::uint32_t i) {
      while (first[i] != i) i = first[i] = first[first[i]];
      return i;
    };
    for_each_overlap(Box_tree(boxes), [&](std::uint32_t i, std::uint32_t j) {
      const auto [least, other] = std::minmax({first_of(i), first_of(j)});
      first[other] = least;
      return true;
    });
    std::vector<std::vector<std::uint32_t>> groups;
    std::vector<std::uint32_t> group_of(count);
    for (const std::uint32_t i : all) {
      if (first_of(i) == i) {
        group_of[i] = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      groups[group_of[first_of(i)]].push_back(i);
    }
    return groups;
  }

  void add_group(const std::vector<std::uint32_t>& group, Offset& offset) const {
    const double d = std::fabs(distance_), room = sources_.room(d);
    Raw_builder builder(sources_, job_, snap(), is_round_);
    for (const std::uint32_t i : group) {
      const Source_curve& c = sources_.curves[i];
      if (!c.is_closed) builder.add_band(c, d);
      else if (sides_[i].left) builder.add_side(c, false, d);
      if (c.is_closed && sides_[i].right) builder.add_side(c, true, d);
    }
    Raw_offset& raw = builder.result();
    const Cover cover(sources_, d, sides_, raw.shapes, is_round_);
    const double error = 4 * raw.gap + room;
    drop_covered(raw, cover, error);
    // edges of specks were moved as far as they are long, or cross where rounding decides
    const bool has_lost_specks = eps_ < job_.eps && (error > eps_ || raw.has_backs);
    if (!raw.has_normals && !raw.has_points && !has_lost_specks) {
      Trimmer trimmer(raw, cover, room);
      if (trimmer.trim()) return add_chains(wanted(std::move(trimmer).loops()), raw, error, offset);
    }
    if (!trim_within_reach(raw, cover, error, offset)) offset.status = Offset_status::UNRESOLVED;
  }

  // Once more where rounding decides, with parts that touch put together.
  bool trim_within_reach(const Raw_offset& raw, const Cover& cover, double error, Offset& offset) const {
    const double room = sources_.room(distance_);
    const double slack = is_round_ ? room : room + 2 * snap();  // normals that follow are that far apart
    const double least = (std::max)({64 * room, 32 * error, is_round_ ? 0 : 16 * slack});  // both sides are seen so
    const bool has_one_side = has_closed_ && (is_simple_ || !is_round_);  // the other one counts as covered
    const auto covers = [&](const Xy<double>& q) {
      return cover.covers(q, -slack) || (has_one_side && is_inside(sources_.winding(q)) == (distance_ > 0));
    };
    for (const double share : Tolerant_trimmer<decltype(covers)>::REACHES) {
      Tolerant_trimmer trimmer(raw, covers, room, (std::max)(least, share * job_.eps), job_.side);
      if (!trimmer.trim()) {
        offset.unresolved = trimmer.unresolved();
        continue;
      }
      offset.unresolved.reset();
      // what is covered has what closed curves enclose in it already, but where all is round
      std::vector<Raw_loop> loops = is_round_ ? wanted(trimmer.loops()) : trimmer.loops();
      const double blunt = 64 * room;
      for (Raw_loop& loop : loops) blunt_cusps(loop, blunt);
      add_chains(loops, raw, error + trimmer.error() + blunt, offset);
      return true;
    }
    return false;
  }
  [[nodiscard]] double snap() const {
    constexpr double OF_EPS = 0x1p-13;
    return OF_EPS * eps_;
  }

  [[nodiscard]] bool is_inside(int winding) const { return is_filled(job_.rule, winding); }
  // Which sides of a curve the offset may be on: of closed curves that do not cross, one.
  [[nodiscard]] Offset_sides sides_of(const Source_curve& c) const {
    if (!is_simple_ || !c.is_closed) return {true, true};
    const int right = sources_.winding_to_the_right(c);
    const bool wanted = distance_ < 0;
    return {is_inside(right + 1) == wanted, is_inside(right) == wanted};
  }
  // The loops that bound what is asked for: each is outside of closed curves, or inside, all of it.
  [[nodiscard]] std::vector<Raw_loop> wanted(std::vector<Raw_loop> loops) const {
    if (!has_closed_ || is_simple_) return loops;
    const auto is_unwanted = [&](const Raw_loop& loop) {
      return is_inside(sources_.winding(moebius_point(loop[loop.size() / 2].arc, 0.5))) != (distance_ < 0);
    };
    loops.erase(std::remove_if(loops.begin(), loops.end(), is_unwanted), loops.end());
    return loops;
  }

  void add_chains(const std::vector<Raw_loop>& loops, const Raw_offset& raw, double error, Offset& offset) const {
    offset.error = (std::max)(offset.error, error);
    const bool is_band = !has_closed_ || distance_ > 0;  // what is asked for is on the right of loops
    for (const Raw_loop& loop : loops) {
      Offset_chain chain;
      chain.pieces.reserve(loop.size());
      for (const Raw_part& p : loop) chain.pieces.push_back(piece_of(p, raw, sources_));
      if (is_band) reverse(chain.pieces);
      const Chain_size size = size_of(chain.pieces);
      // thinner than that and it is not there at a distance within eps
      constexpr double VANISHES = 0x1p-4;
      if (2 * std::fabs(size.area) <= VANISHES * job_.eps * size.length) continue;
      if (!has_closed_ && job_.side != Offset_side::BOTH) {
        add_one_side(loop, raw, sources_, job_.side, offset.chains);
        continue;
      }
      chain.area = size.area;
      chain.is_ccw = size.area > 0;
      offset.chains.push_back(std::move(chain));
    }
  }

  const Source_arcs& sources_;
  const Offset_job& job_;
  std::vector<Offset_sides> sides_;  // of each curve
  double distance_, eps_;
  bool is_simple_, is_round_ = true, has_open_ = false;
  bool has_closed_ = false;  // curves that enclose something
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
