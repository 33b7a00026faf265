// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of offset/Offset_source_2.h.

#include "Offset_run.h"
#include "Offset_sources.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/region/region_bounds.h>
#include <CGAL/Bounding_arcs_2/tree/tree_spirals.h>
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

namespace internal {

/// A part of the tolerance: arcs as short as that are none.
constexpr double OF_TINY_ARCS = 0x1p-10;
/// The part of the tolerance that chains of arcs take.
constexpr double OF_ARCS = 0.75;

/// The largest |coordinate| of ends of arcs.
[[nodiscard]] static double coordinate_size(const std::vector<Offset::Chain>& chains) {
  double size = 0;
  for (const Offset::Chain& chain : chains)
    for (const Offset::Piece& p : chain.pieces)
      for (const Xy<double>& q : {p.arc.from, p.arc.to}) size = (std::max)({size, std::fabs(q.x), std::fabs(q.y)});
  return size;
}

Offset_sources::Offset_sources(const Unit& unit, double eps, const Offset::Options& options)
    : unit_(unit), options_(options) {
  if (!(eps > 0) || !std::isfinite(eps)) throw std::invalid_argument(expected("eps", "a finite number above 0", eps));
  if (!(options.miter_limit >= 1))
    throw std::invalid_argument(expected("miter limit", "a number of at least 1", options.miter_limit));
  constexpr double MOST = 0x1p200;  // more is as much
  eps_ = (std::min)(unit.tolerance_in(eps), MOST);
}

Offset_sources::Offset_sources(const Bounding_arc_tree_2& tree, double eps, const Offset::Options& options,
                               bool drops_open)
    : Offset_sources(tree.unit(), eps, options) {
  add_segments(tree.in_unit(), drops_open);
  chain_error_ += OF_TINY_ARCS * eps_ + unit_.in(tree.rounding());
  part_closed_and_open();
}

// Curves are made arcs of some hundred at a time: what arcs are fitted to takes ten times as much memory as what is
// kept.
void Offset_sources::add_segments(const Segment_hierarchy& segments, bool drops_open) {
  constexpr std::size_t AT_ONCE = 2048;  // Bezier pieces
  const auto& curves = segments.drawing().curves();
  const std::size_t pieces = segments.number_of_beziers();
  std::size_t done = 0;
  for (std::size_t first = 0, last = 0; first < curves.size(); first = last) {
    std::size_t count = 0;
    while (last < curves.size() && count < AT_ONCE) count += curves[last++].beziers.size();
    add_curves(segments, first, last, drops_open);
    done += count;
    if (first == 0 && last < curves.size()) {  // as many as those of the first ones, and an eighth more
      const double arcs_of_each = static_cast<double>(all_.arcs.size()) / static_cast<double>(done);
      all_.arcs.reserve(static_cast<std::size_t>(1.125 * arcs_of_each * static_cast<double>(pieces)));
    }
  }
}

void Offset_sources::add_curves(const Segment_hierarchy& segments, std::size_t first, std::size_t last,
                                bool drops_open) {
  const auto& curves = segments.drawing().curves();
  const std::vector<Bezier_spiral_2<double>> spirals = spiral_segments(segments, segments.drawing(), first, last);
  const Arc_chain chain = arc_chain(spirals, OF_ARCS * eps_);
  chain_error_ = (std::max)(chain_error_, chain.error);
  is_resolved_ = is_resolved_ && chain.status == Build_status::COMPLETE;
  const auto arc_at = [&](std::size_t i) { return chain.arcs.begin() + static_cast<std::ptrdiff_t>(i); };
  std::size_t begin = 0;
  for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) {
    const auto& curve = curves[i];
    const auto is_point = [&] {
      for (std::uint32_t j = 0; j < curve.beziers.size(); ++j)
        if (!segments.is_point(segments.number_of_bezier(i, j))) return false;
      return true;
    };
    const bool is_left_out = drops_open && (!curve.is_closed || is_point());
    std::size_t end = begin;
    while (end < chain.arcs.size() && spirals[chain.arcs[end].spiral].place().curve == i) ++end;
    if (!is_left_out)
      add_curve({arc_at(begin), arc_at(end)}, spirals, i, curve.is_closed,
                curve.beziers.front().control_points().front());
    begin = end;
  }
}

Offset_sources::Offset_sources(const std::vector<Offset::Chain>& chains, double eps, const Offset::Options& options)
    : Offset_sources(Unit::of_size(coordinate_size(chains)), eps, options) {
  for (std::uint32_t i = 0; i < chains.size(); ++i) {
    std::vector<Arc_chain::Arc> arcs;
    for (const Offset::Piece& p : chains[i].pieces) {
      if (!is_queried(p.arc.from) || !is_queried(p.arc.to))
        throw std::invalid_argument(expected("chain " + text_of(i), "coordinates up to 2^500 (3e150)",
                                             is_queried(p.arc.from) ? p.arc.to : p.arc.from));
      arcs.push_back({{unit_.in(p.arc.from), unit_.in(p.arc.to), p.arc.bulge}, 0, 1, 0, 0});
    }
    if (!arcs.empty()) add_curve(arcs, {}, i, chains[i].is_closed, arcs.front().from);
  }
  chain_error_ = OF_TINY_ARCS * eps_;
  part_closed_and_open();
}

void Offset_sources::part_closed_and_open() {
  all_.finish();
  // points are open curves, but for what is left of closed ones
  const auto is_closed = [](const Source_curve& c) { return c.is_closed || c.is_speck; };
  has_closed_ = std::any_of(all_.curves.begin(), all_.curves.end(), is_closed);
  has_both_ = has_closed_ && !std::all_of(all_.curves.begin(), all_.curves.end(), is_closed);
  if (!has_both_) return;
  for (const Source_curve& c : all_.curves) (is_closed(c) ? closed_ : open_).add_copy(all_, c);
  closed_.finish();
  open_.finish();
}

// A closed curve that is small or thin beside eps is followed more closely, until its arcs tell what it runs round.
void Offset_sources::add_curve(std::vector<Arc_chain::Arc> arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                               std::uint32_t curve, bool is_closed, const Xy<double>& start) {
  constexpr int TIMES = 4;
  constexpr double CLOSER = 0x1p-4;
  double eps = eps_;
  if (is_closed && !arcs.empty()) {
    CGAL::Bbox_2 box;
    for (const Arc_chain::Arc& a : arcs) box += CGAL::Bbox_2(a.from.x, a.from.y, a.from.x, a.from.y);
    const double extent = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
    if (extent > 0) eps = (std::min)(eps, CLOSER * extent);
    else arcs.clear();  // it is a point
  }
  for (int time = 1;; ++time) {
    double error = 0;
    for (const Arc_chain::Arc& a : arcs) error = (std::max)(error, a.error);
    add_arcs(arcs, spirals, curve, is_closed, start, eps);
    all_.end_curve(eps, error);
    const Source_curve& c = all_.curves.back();
    if (!c.is_closed || spirals.empty() || time == TIMES || (error <= c.eps && !is_thin(c))) return;
    eps = (std::min)(c.eps, CLOSER * eps);
    all_.remove_last();
    const std::size_t first = arcs.front().spiral, last = arcs.back().spiral;
    const auto at = [&](std::size_t i) { return spirals.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::vector<Bezier_spiral_2<double>> own(at(first), at(last + 1));
    Arc_chain chain = arc_chain(own, OF_ARCS * eps);
    arcs = std::move(chain.arcs);
    for (Arc_chain::Arc& a : arcs) a.spiral += first;
  }
}

void Offset_sources::add_arcs(const std::vector<Arc_chain::Arc>& arcs,
                              const std::vector<Bezier_spiral_2<double>>& spirals, std::uint32_t curve, bool is_closed,
                              const Xy<double>& start, double eps) {
  all_.begin_curve(is_closed, start);
  const std::size_t begin = all_.arcs.size();
  // Arcs as short as that have no direction but for rounding.  What is around them meets in their place, at a corner.
  const double tiny = OF_TINY_ARCS * eps;
  Xy<double> last = arcs.empty() ? start : arcs.front().from;
  for (const Arc_chain::Arc& a : arcs) {
    const Xy<double> step = a.to - last;
    if (euclidean_norm(step) <= tiny) continue;
    const auto bezier =
        spirals.empty() ? static_cast<std::uint32_t>(&a - arcs.data()) : spirals[a.spiral].place().bezier;
    all_.add({last, a.to, a.bulge}, curve, bezier, a.t0, a.t1);
    last = a.to;
  }
  if (all_.arcs.size() > begin) all_.move_end(arcs.back().to);
  else all_.add_point(curve, !arcs.empty());
}

static void note_unresolved(const Filled_outline& outline, Offset& offset) {
  if (outline.is_resolved()) return;
  offset.status = Offset::Status::UNRESOLVED;
  offset.unresolved = outline.unresolved();
}

// Everything back from the unit.
Offset Offset_sources::out(Offset offset) const {
  constexpr int OF_AREAS = 2;
  if (offset.unresolved) offset.unresolved = unit_.out(*offset.unresolved);
  offset.error = unit_.bounds_out(Bracket{0, offset.error}).upper;
  for (Offset::Chain& chain : offset.chains) {
    chain.area = unit_.out(chain.area, OF_AREAS);
    for (Offset::Piece& p : chain.pieces) {
      p.arc.from = unit_.out(p.arc.from), p.arc.to = unit_.out(p.arc.to);
      if (!is_queried(p.arc.from) || !is_queried(p.arc.to))
        throw std::invalid_argument(
            expected("offset", "coordinates up to 2^500 (3e150)", is_queried(p.arc.from) ? p.arc.to : p.arc.from));
    }
  }
  return offset;
}

Offset Offset_sources::at(double d) const {
  constexpr double LEAST = 0x1p-250, MOST = 0x1p150;  // products of four lengths stay in range
  if (!std::isfinite(d)) throw std::invalid_argument(expected("distance", "a finite number", d));
  const double exact = std::fabs(unit_.in(d));
  if (!(std::fabs(d) <= LARGEST_QUERIED && exact <= MOST))
    throw std::invalid_argument(
        expected("distance", "a number up to 2^500 (3e150), and up to 2^100 (1e30) times the drawing's size", d));
  const double in_unit = d == 0 ? 0 : (std::max)(exact, LEAST);
  Offset offset = out(in_unit_at(std::copysign(in_unit, d), in_unit - exact));
  if (d != 0) offset.distance = d;
  return offset;
}

Offset Offset_sources::in_unit_at(double d, double error) const {
  if (d == 0) return unmoved(all_, chain_error_);
  Offset offset;
  offset.side = options_.side;
  const auto run = [&](const Source_arcs& sources) { Offset_run(sources, options_, eps_, d).add_to(offset); };
  if (d < 0 && has_closed_ && options_.side == Offset::Side::BOTH) {
    const Filled_outline& outline = filled();
    run(outline.has_walls() ? outline.chains() : closed());
    if (outline.has_walls()) offset.error += outline.error();
    note_unresolved(outline, offset);
    if (has_both_) run(open_);
  } else if (has_both_ && options_.side != Offset::Side::BOTH) {
    run(closed_);
    run(open_);
  } else {
    run(all_);
  }
  offset.error += chain_error_ + error;
  make_few(offset, eps_, all_.room(d));
  finish_status(offset);
  return offset;
}

void Offset_sources::finish_status(Offset& offset) const {
  if (offset.status == Offset::Status::COMPLETE && !(is_resolved_ && offset.error <= eps_))
    offset.status = Offset::Status::RESOLUTION_REACHED;
}

const Filled_outline& Offset_sources::filled() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!filled_) filled_.emplace(closed(), options_.rule, eps_);
  return *filled_;
}

std::vector<std::uint32_t> Offset_sources::left_out() const {
  return has_closed_ ? filled().left_out() : std::vector<std::uint32_t>();
}

Offset Offset_sources::outline() const {
  if (!has_closed_) return {};
  const Filled_outline& outline = filled();
  Offset offset = unmoved(outline.with_chosen(closed()), chain_error_ + outline.error());
  note_unresolved(outline, offset);
  finish_status(offset);
  return out(std::move(offset));
}

Offset Offset_sources::unmoved(const Source_arcs& sources, double error) const {
  Offset offset;
  offset.error = error;
  for (const Source_curve& c : sources.curves) {
    if (!c.is_closed) continue;
    Offset::Chain chain;
    for (std::uint32_t i = c.begin; i < c.end; ++i) {
      const Source_arc& s = sources.arcs[i];
      chain.pieces.push_back({s.arc, {s.curve, s.bezier, s.t0}, s.t1, Offset::Kind::CURVE, true, 0});
    }
    chain.area = c.area;
    chain.is_ccw = c.area > 0;
    offset.chains.push_back(std::move(chain));
  }
  nest(offset.chains, 0);
  make_few(offset, eps_, sources.room(0));
  return offset;
}

}  // namespace internal

Offset_source_2::Offset_source_2(const Bounding_arc_tree_2& tree, double eps, const Offset::Options& options)
    : sources_(std::make_shared<const internal::Offset_sources>(tree, eps, options)) {}
Offset_source_2::Offset_source_2(const std::vector<Offset::Chain>& chains, double eps, const Offset::Options& options)
    : sources_(std::make_shared<const internal::Offset_sources>(chains, eps, options)) {}

Offset Offset_source_2::at(double d) const { return sources_->at(d); }
std::vector<Offset> Offset_source_2::at(const std::vector<double>& distances) const {
  std::vector<Offset> result;
  result.reserve(distances.size());
  for (const double d : distances) result.push_back(at(d));
  return result;
}

Offset Offset_source_2::outline() const { return sources_->outline(); }
std::vector<std::uint32_t> Offset_source_2::left_out() const { return sources_->left_out(); }
std::size_t Offset_source_2::number_of_arcs() const { return sources_->number_of_arcs(); }

}  // namespace CGAL::Bounding_arcs
