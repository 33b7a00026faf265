// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One offset of some chains: which sides are offset, the raw offset, and its trimming, which leaves no
// self-intersection.  Trimmer.h trims by the signs of crossings, Tolerant_trimmer.h where rounding decides signs.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_RUN_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_RUN_H

#include "Raw_offset.h"
#include "Tolerant_trimmer.h"
#include "Trimmer.h"
#include "offset_chains.h"

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../arc/arc_crossings.h"
#include "../tree/Box_tree.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

// Cuts off the tips of loops that turn back.
//
//      ______________        Where a strip is just as wide as two distances, what is left of its ends begins with two
//     |_____             ->  parts that touch: next to the tip rounding tells which of them is on which side, and they
//           \____            cross.  Cut off where they are farther apart than that, they do not.

/// Cuts off a share of the part's length from its end, or from its start.
inline void shorten(Raw_part& part, double share, bool is_end) {
  const double bulge = std::tan(std::atan(part.arc.bulge) * (1 - share)), along = share * (part.v - part.u);
  if (is_end) {
    part.arc = {part.arc.from, point(part.arc, 1 - share), bulge};
    part.v -= along;
  } else {
    part.arc = {point(part.arc, share), part.arc.to, bulge};
    part.u += along;
  }
}

/// \param width how far parts are apart where they are cut; some times what rounding may move their points by
/// \return how far they are, at most, which is hardly more; 0 without such tips
inline double blunt_cusps(Raw_loop& loop, double width) {
  constexpr double TURNS_BACK = 0x1p-20,  // the sine of an angle within which rounding may decide
      LEAST = 0x1p-40, MOST = 0x1p-2;     // shares of the shorter part
  constexpr int HALVINGS = 10;            // sides part as the square of what is cut off
  std::vector<std::optional<Raw_part>> tips(loop.size());
  const std::size_t n = loop.size();
  double most = 0;
  for (std::size_t i = 0; n > 1 && i < n; ++i) {
    Raw_part &a = loop[i], &b = loop[(i + 1) % n];
    const Xy<double> coming = tangent(a.arc, 1), going = tangent(b.arc, 0);
    if (dot(coming, going) > 0 || std::fabs(cross(coming, going)) > TURNS_BACK) continue;
    const double of_a = length(a.arc), of_b = length(b.arc), shorter = (std::min)(of_a, of_b);
    const auto apart = [&](double share) {
      return euclidean_norm(point(a.arc, 1 - share * shorter / of_a) - point(b.arc, share * shorter / of_b));
    };
    double share = LEAST;
    while (share <= MOST && apart(share) < width) share *= 2;
    if (share > MOST) continue;
    double low = share / 2;
    for (int k = 0; k < HALVINGS && share > LEAST; ++k) {
      const double middle = 0.5 * (low + share);
      (apart(middle) < width ? low : share) = middle;
    }
    most = (std::max)(most, apart(share));
    shorten(a, share * shorter / of_a, true);
    shorten(b, share * shorter / of_b, false);
    tips[i] = Raw_part{a.edge, {a.arc.to, b.arc.from, 0}, a.v, a.v};
  }
  if (most == 0) return 0;
  Raw_loop result;
  for (std::size_t i = 0; i < n; ++i) {
    result.push_back(loop[i]);
    if (tips[i]) result.push_back(*tips[i]);
  }
  loop = std::move(result);
  return most;
}

// Leaves out of a raw offset what is covered as a whole, so that its crossings need not be found.
//
// Most of a raw offset far beyond radii and gaps is that, and edges there cross as the square of their number.  What
// is left over of an offset loses nothing: where it goes on from one edge to another neither is covered, so that these
// crossings are found as before.

/// Whether a part of an arc is covered, by more than a depth: a disc that holds it, or those of its halves.
[[nodiscard]] inline bool is_covered(const Arc_2& arc, double u, double v, const Cover& cover, double depth,
                                     int halvings) {
  // no point of at most half a circle is farther from its middle than its ends, which a little more makes up for
  constexpr double ROUNDING = 1 + 0x1p-20;
  const Xy<double> middle = moebius_point(arc, (u + v) / 2);
  const double radius =
      (std::max)(euclidean_norm(moebius_point(arc, u) - middle), euclidean_norm(moebius_point(arc, v) - middle));
  if (cover.covers(middle, ROUNDING * radius + depth)) return true;
  if (halvings == 0 || !cover.covers(middle, depth)) return false;
  return is_covered(arc, u, (u + v) / 2, cover, depth, halvings - 1) &&
         is_covered(arc, (u + v) / 2, v, cover, depth, halvings - 1);
}

/// Sets a flag of those of a few edges that are covered: all at once, or each by itself where they are long and the
/// one in the middle looks covered.
inline void find_covered(const Raw_offset& raw, std::uint32_t begin, std::uint32_t end, const Cover& cover,
                         double depth, std::vector<bool>::iterator flag) {
  constexpr int HALVINGS = 4;
  CGAL::Bbox_2 box = box_about(raw.edges[begin].arc);
  for (std::uint32_t i = begin + 1; i < end; ++i) box += box_about(raw.edges[i].arc);
  const Xy<double> center{box.xmin() / 2 + box.xmax() / 2, box.ymin() / 2 + box.ymax() / 2};
  const double radius = euclidean_norm(Xy<double>{box.xmax(), box.ymax()} - center);
  if (radius < cover.distance() && cover.covers(center, radius + depth)) {
    std::fill_n(flag, end - begin, true);
    return;
  }
  if (2 * radius < cover.distance()) return;
  if (!cover.covers(moebius_point(raw.edges[(begin + end) / 2].arc, 0.5), depth)) return;
  for (std::uint32_t i = begin; i < end; ++i, ++flag)
    *flag = is_covered(raw.edges[i].arc, 0, 1, cover, depth, HALVINGS);
}

inline void drop_covered(Raw_offset& raw, const Cover& cover, double depth) {
  constexpr std::uint32_t AT_ONCE = 4;
  std::vector<Raw_edge> edges;
  std::vector<Raw_run> runs;
  edges.reserve(raw.edges.size());
  std::vector<bool> is_dead;
  for (const Raw_run& run : raw.runs) {
    const std::uint32_t length = run.end - run.begin;
    is_dead.assign(length, false);
    for (std::uint32_t i = 0; i < length; i += AT_ONCE) {
      const std::uint32_t end = (std::min)(i + AT_ONCE, length);
      find_covered(raw, run.begin + i, run.begin + end, cover, depth, is_dead.begin() + i);
    }
    const auto dead = static_cast<std::uint32_t>(std::find(is_dead.begin(), is_dead.end(), true) - is_dead.begin());
    const bool is_whole = dead == length;
    const std::uint32_t first = run.is_closed && !is_whole ? dead : 0;  // an open run's seam is where it is broken
    auto begin = static_cast<std::uint32_t>(edges.size());
    const auto finish = [&] {
      const auto end = static_cast<std::uint32_t>(edges.size());
      if (end > begin) runs.push_back({begin, end, run.is_closed && is_whole});
      begin = end;
    };
    for (std::uint32_t k = 0; k < length; ++k) {
      const std::uint32_t i = (first + k) % length;
      if (is_dead[i]) finish();
      else edges.push_back(raw.edges[run.begin + i]);
    }
    finish();
  }
  raw.edges = std::move(edges);
  raw.runs = std::move(runs);
}

class Offset_run {
 public:
  /// \param eps how near the offset is to be
  Offset_run(const Source_arcs& sources, const Offset::Options& options, double eps, double d)
      : sources_(sources), options_(options), distance_(d), eps_asked_(eps), eps_((std::min)(eps, sources.least_eps())),
        is_simple_(sources.is_simple() && options.side == Offset::Side::BOTH) {
    for (const Source_curve& c : sources.curves) {
      has_open_ = has_open_ || !c.is_closed;
      if (is_thin(c)) is_simple_ = false;
      has_closed_ = has_closed_ || (c.is_closed && options.side == Offset::Side::BOTH);  // one side is that of a band
    }
    is_simple_ = is_simple_ && !(has_open_ && has_closed_);  // bands end at offsets inside what encloses them
    is_round_ = options.join == Offset::Join::ROUND && (options.cap == Offset::Cap::ROUND || !has_open_);
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
    boost::disjoint_sets_with_storage<> sets(count);
    for_each_overlap(Box_tree(boxes), [&](std::uint32_t i, std::uint32_t j) {
      sets.union_set(i, j);
      return true;
    });
    std::vector<std::vector<std::uint32_t>> groups;
    std::vector<std::size_t> group_of(count, count);  // of sets, by the curve that stands for one
    for (const std::uint32_t i : all) {
      std::size_t& group = group_of[sets.find_set(i)];
      if (group == count) {
        group = groups.size();
        groups.emplace_back();
      }
      groups[group].push_back(i);
    }
    return groups;
  }

  void add_group(const std::vector<std::uint32_t>& group, Offset& offset) const {
    const double d = std::fabs(distance_), room = sources_.room(d);
    Raw_builder builder(sources_, options_, snap(), is_round_);
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
    const bool has_lost_specks = eps_ < eps_asked_ && (error > eps_ || raw.has_backs);
    if (!raw.has_normals && !raw.has_points && !has_lost_specks) {
      Trimmer trimmer(raw, cover, room);
      if (trimmer.trim()) return add_chains(wanted(std::move(trimmer).loops()), raw, error, offset);
    }
    if (!trim_within_reach(raw, cover, error, offset)) offset.status = Offset::Status::UNRESOLVED;
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
      Tolerant_trimmer trimmer(raw, covers, room, (std::max)(least, share * eps_asked_), options_.side);
      if (!trimmer.trim()) {
        offset.unresolved = trimmer.unresolved();
        continue;
      }
      offset.unresolved.reset();
      // what is covered has what closed curves enclose in it already, but where all is round
      std::vector<Raw_loop> loops = is_round_ ? wanted(trimmer.loops()) : trimmer.loops();
      double blunt = 64 * room;
      for (Raw_loop& loop : loops) blunt = (std::max)(blunt, blunt_cusps(loop, 64 * room));
      add_chains(loops, raw, error + trimmer.error() + blunt, offset);
      return true;
    }
    return false;
  }
  [[nodiscard]] double snap() const {
    constexpr double OF_EPS = 0x1p-13;
    return OF_EPS * eps_;
  }

  [[nodiscard]] bool is_inside(int winding) const { return is_filled(options_.rule, winding); }
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
      Offset::Chain chain;
      chain.pieces.reserve(loop.size());
      for (const Raw_part& p : loop) chain.pieces.push_back(piece_of(p, raw, sources_));
      if (is_band) reverse(chain.pieces);
      const Chain_size size = size_of(chain.pieces);
      // thinner than that and it is not there at a distance within eps
      constexpr double VANISHES = 0x1p-4;
      if (2 * std::fabs(size.area) <= VANISHES * eps_asked_ * size.length) continue;
      if (!has_closed_ && options_.side != Offset::Side::BOTH) {
        add_one_side(loop, raw, sources_, options_.side, offset.chains);
        continue;
      }
      chain.area = size.area;
      chain.is_ccw = size.area > 0;
      offset.chains.push_back(std::move(chain));
    }
  }

  const Source_arcs& sources_;
  const Offset::Options& options_;
  std::vector<Offset_sides> sides_;    // of each curve
  double distance_, eps_asked_, eps_;  // the latter also that of small curves
  bool is_simple_, is_round_ = true, has_open_ = false;
  bool has_closed_ = false;  // curves that enclose something
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
