// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What Offset_source_2 (offset/Offset_source_2.h) keeps: arcs of closed and open curves, in the unit of the tree.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_SOURCES_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_OFFSET_SOURCES_H

#include "Raw_offset.h"
#include "Source_arcs.h"
#include "Tolerant_trimmer.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_2.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>
#include "../tree/Segment_hierarchy.h"

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

/// What of closed curves bounds what they enclose: the parts with what is filled on one side alone.
///
///      ___ ___          Two discs: the arcs inside are run round by the other circle, and are walls that an offset
///     /  _X_  \         inwards must not see.  Curves that do not cross are walls as a whole or not at all; others are
///    |  | | |  |        cut where they meet, and united, as raw offsets are whose parts touch: the same trimmer, which
///     \__ X __/         asks whether next to a part it is empty.
class Filled_outline {
 public:
  /// \param closed curves, all of them but specks
  Filled_outline(const Source_arcs& closed, Fill_rule rule, double eps) {
    if (closed.is_simple() && std::none_of(closed.curves.begin(), closed.curves.end(), is_thin))
      choose_curves(closed, rule);
    else unite(closed, rule, eps);
    if (!has_walls_) return;
    outline_ = with_chosen(closed);
    chosen_.clear();
    outline_.finish();
  }

  /// Chains that do not cross, with what is filled on their left, to be offset. \pre there are walls
  [[nodiscard]] const Source_arcs& chains() const { return outline_; }
  /// Returns these chains in any case. \param closed as before
  [[nodiscard]] Source_arcs with_chosen(const Source_arcs& closed) const {
    Source_arcs chains = outline_;
    for (const Chosen& chosen : chosen_) {
      chains.add_copy(closed, closed.curves[chosen.curve]);
      if (chosen.is_reversed) chains.reverse_last();
    }
    return chains;
  }
  /// Whether there are parts of the curves that do not bound anything: if not, the curves may be taken as they are.
  [[nodiscard]] bool has_walls() const { return has_walls_; }
  /// Curves of the drawing that bound nothing: all sides of theirs are filled, or none is.
  [[nodiscard]] const std::vector<std::uint32_t>& left_out() const { return left_out_; }
  /// Whether parts made loops; else there are no chains.
  [[nodiscard]] bool is_resolved() const { return is_resolved_; }
  [[nodiscard]] const Xy<double>& unresolved() const { return unresolved_; }  ///< a place where they do not
  /// How far points of the chains may be from the curves' arcs, and of bounding parts of these from the chains.
  [[nodiscard]] double error() const { return error_; }

 private:
  void choose_curves(const Source_arcs& closed, Fill_rule rule) {
    for (std::uint32_t i = 0; i < closed.curves.size(); ++i) {
      const Source_curve& c = closed.curves[i];
      if (!c.is_closed) {
        has_walls_ = true;
        continue;
      }
      const int right = closed.winding_to_the_right(c);
      const bool is_left = is_filled(rule, right + 1), is_right = is_filled(rule, right);
      if (is_left == is_right) {
        has_walls_ = true;
        left_out_.push_back(closed.arcs[c.begin].curve);
        continue;
      }
      chosen_.push_back({i, is_right});
    }
  }

  void unite(const Source_arcs& closed, Fill_rule rule, double eps) {
    Raw_offset raw;
    const std::vector<double> turns = closed.turns();
    for (const Source_curve& c : closed.curves) {
      if (!c.is_closed) continue;
      const auto begin = static_cast<std::uint32_t>(raw.edges.size());
      raw.runs.push_back({begin, begin + (c.end - c.begin), true});
      for (std::uint32_t i = c.begin; i < c.end; ++i)
        raw.edges.push_back({closed.arcs[i].arc, i, Offset::Kind::CURVE, true, false, false, turns[i]});
    }
    const auto is_empty = [&](const Xy<double>& q) { return !is_filled(rule, closed.winding(q)); };
    const double room = closed.room(0);
    for (const double share : Tolerant_trimmer<decltype(is_empty)>::REACHES) {
      Tolerant_trimmer trimmer(raw, is_empty, room, (std::max)(64 * room, share * closed.least_eps()));
      if (!trimmer.trim()) {
        unresolved_ = trimmer.unresolved();
        continue;
      }
      has_walls_ = trimmer.leaves_out() || raw.edges.size() < closed.arcs.size();
      error_ = trimmer.error();
      std::vector<bool> is_there(closed.curves.size(), false);
      for (const Raw_loop& loop : trimmer.loops()) {
        add(loop, closed, raw, eps);
        for (const Raw_part& part : loop) is_there[closed.arcs[raw.edges[part.edge].source].chain] = true;
      }
      for (std::size_t i = 0; i < closed.curves.size(); ++i)
        if (closed.curves[i].is_closed && !is_there[i]) left_out_.push_back(closed.arcs[closed.curves[i].begin].curve);
      return;
    }
    is_resolved_ = false;
  }
  void add(const Raw_loop& loop, const Source_arcs& closed, const Raw_offset& raw, double eps) {
    outline_.begin_curve(true, loop.front().arc.from);
    for (const Raw_part& part : loop) {
      const Source_arc& s = closed.arcs[raw.edges[part.edge].source];
      const auto at = [&s](double u) { return s.t0 + u * (s.t1 - s.t0); };
      outline_.add(part.arc, s.curve, s.bezier, at(part.u), at(part.v));
    }
    outline_.end_curve(eps, 0);
  }

  struct Chosen {
    std::uint32_t curve;
    bool is_reversed;
  };

  Source_arcs outline_;
  std::vector<std::uint32_t> left_out_;
  std::vector<Chosen> chosen_;  // curves that are chains as they are, or backwards
  bool has_walls_ = false, is_resolved_ = true;
  double error_ = 0;
  Xy<double> unresolved_;
};

/// Arcs of curves, ready for offsets at any number of distances.
class Offset_sources {
 public:
  /// \param drops_open leaves out open curves and points
  Offset_sources(const Bounding_arc_tree_2& tree, double eps, const Offset::Options& options, bool drops_open = false);
  Offset_sources(const std::vector<Offset::Chain>& chains, double eps, const Offset::Options& options);

  /// See Offset_source_2.
  [[nodiscard]] Offset at(double d) const;
  [[nodiscard]] Offset outline() const;
  [[nodiscard]] std::vector<std::uint32_t> left_out() const;
  [[nodiscard]] std::size_t number_of_arcs() const { return all_.arcs.size(); }

 private:
  void add_segments(const Segment_hierarchy& segments, bool drops_open);
  void add_curves(const Segment_hierarchy& segments, std::size_t first, std::size_t last, bool drops_open);
  void add_curve(std::vector<Arc_chain::Arc> arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                 std::uint32_t curve, bool is_closed, const Xy<double>& start);
  void add_arcs(const std::vector<Arc_chain::Arc>& arcs, const std::vector<Bezier_spiral_2<double>>& spirals,
                std::uint32_t curve, bool is_closed, const Xy<double>& start, double eps);
  void part_closed_and_open();
  [[nodiscard]] const Source_arcs& closed() const { return has_both_ ? closed_ : all_; }
  [[nodiscard]] const Filled_outline& filled() const;
  [[nodiscard]] Offset unmoved(const Source_arcs& sources, double error) const;
  [[nodiscard]] Offset in_unit_at(double d, double error) const;
  [[nodiscard]] Offset out(Offset offset) const;
  void finish_status(Offset& offset) const;

  Offset_sources(const Unit& unit, double eps, const Offset::Options& options);

  Unit unit_;  // of all that follows
  Offset::Options options_;
  double eps_;
  Source_arcs all_, closed_, open_;  // the last two only where there are both
  bool has_both_ = false, has_closed_ = false;
  mutable std::mutex mutex_;
  mutable std::optional<Filled_outline> filled_;  // not needed for d > 0
  double chain_error_ = 0;
  bool is_resolved_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
