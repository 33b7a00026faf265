// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Cut_curves.h.

#include "Cut_curves.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>
#include "../query/Intersection_search.h"
#include "../tree/Segment_hierarchy.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

namespace CGAL::Bounding_arcs::internal {

Cut_curves::Cut_curves(const Segment_hierarchy& curves, bool at_joints)
    : curves_(curves), places_(curves, curves, Intersection_search(curves).by_pieces()),
      first_place_(static_cast<std::uint32_t>(curves.number_of_beziers() + curves.drawing().curves().size())),
      nodes_(first_place_ + 2 * places_.meetings().size()), undecided_(places_.undecided()) {
  if (!undecided_) add_cuts(at_joints);
  if (undecided_) return;
  add_edges();
  join_edges();
  node_behind_ = cut_of_node_ = {};
  nodes_ = Joined_sets(0);
}

std::uint32_t Cut_curves::node_of(Place_number p) const {
  const Bracket& t = places_.bracket(p);
  if (t.is_single() && t.lower == 0) return places_.bezier_of(p);
  if (t.is_single() && t.lower == 1) return node_behind_[places_.bezier_of(p)];
  return first_place_ + p;
}

void Cut_curves::add_cuts(bool at_joints) {
  const auto& drawn = curves_.drawing().curves();
  const auto beziers = static_cast<std::uint32_t>(curves_.number_of_beziers());
  const auto places = static_cast<Place_number>(2 * places_.meetings().size());
  for (std::uint32_t c = 0; c < drawn.size(); ++c)
    for (std::uint32_t b = 0; b < drawn[c].beziers.size(); ++b) {
      const bool is_last = b + 1 == drawn[c].beziers.size();
      const std::uint32_t end = drawn[c].is_closed ? curves_.number_of_bezier(c, 0) : beziers + c;
      node_behind_.push_back(is_last ? end : curves_.number_of_bezier(c, b + 1));
    }
  std::vector<char> is_cut(first_place_, at_joints ? 1 : 0);
  std::vector<Place_number> inside;  // neither at joints nor at ends
  for (Place_number p = 0; p < places; ++p) {
    const std::uint32_t node = node_of(p);
    if (p % 2 == 0) nodes_.join(node, node_of(p + 1));
    if (node < first_place_) is_cut[node] = 1;
    else inside.push_back(p);
  }
  std::sort(inside.begin(), inside.end(),
            [this](Place_number p, Place_number q) { return places_.bezier_of(p) < places_.bezier_of(q); });
  cut_of_node_.assign(first_place_ + places, NO_NUMBER);
  std::vector<std::uint32_t> nodes;  // by cut
  const auto add = [&](std::uint32_t bezier, double t, std::uint32_t node) {
    cut_of_node_[node] = static_cast<std::uint32_t>(cuts_.size());
    cuts_.push_back({{bezier, {t, t}}, 0, NO_NUMBER});
    nodes.push_back(node);
  };
  first_on_.reserve(beziers + 1);
  std::vector<Place_number> of_piece;
  std::size_t next = 0;
  for (std::uint32_t c = 0; c < drawn.size(); ++c) {
    const std::uint32_t first = curves_.number_of_bezier(c, 0),
                        end = curves_.number_of_bezier(c, drawn[c].beziers.size());
    first_cut_.push_back(static_cast<std::uint32_t>(cuts_.size()));
    for (std::uint32_t b = first; b < end; ++b) {
      first_on_.push_back(static_cast<std::uint32_t>(cuts_.size()));
      if (is_cut[b] != 0 || (b == first && !drawn[c].is_closed)) add(b, 0, b);
      of_piece.clear();
      while (next < inside.size() && places_.bezier_of(inside[next]) == b) of_piece.push_back(inside[next++]);
      if (!of_piece.empty() && !add_cuts_inside(b, of_piece, nodes)) return;
    }
    if (!drawn[c].is_closed && first < end) add(end - 1, 1, beziers + c);
  }
  first_cut_.push_back(static_cast<std::uint32_t>(cuts_.size()));
  first_on_.push_back(static_cast<std::uint32_t>(cuts_.size()));
  cuts_.shrink_to_fit();
  number_vertices(nodes);
}

// Cuts between the ends of a piece: of each class of equal places one.
bool Cut_curves::add_cuts_inside(std::uint32_t bezier, const std::vector<Place_number>& places,
                                 std::vector<std::uint32_t>& nodes) {
  const Sorted_places sorted = places_.sorted(places);
  undecided_ = sorted.undecided;
  for (const auto& equal : sorted.classes) {
    Place_number place = equal.front();
    Bracket t = places_.bracket(place);
    for (const Place_number p : equal) {
      const Bracket& own = places_.bracket(p);
      t = {(std::max)(t.lower, own.lower), (std::min)(t.upper, own.upper)};
      if (own.is_single()) place = p;
      nodes_.join(first_place_ + equal.front(), first_place_ + p);
      cut_of_node_[first_place_ + p] = static_cast<std::uint32_t>(cuts_.size());
    }
    cuts_.push_back({{bezier, t}, 0, place});
    nodes.push_back(first_place_ + place);
  }
  return !undecided_;
}

void Cut_curves::number_vertices(const std::vector<std::uint32_t>& nodes) {
  std::vector<std::uint32_t> number_of_set(cut_of_node_.size(), NO_NUMBER);
  for (std::size_t c = 0; c < cuts_.size(); ++c) {
    std::uint32_t& number = number_of_set[nodes_.find(nodes[c])];
    if (number == NO_NUMBER) number = vertices_++;
    cuts_[c].vertex = number;
  }
  by_vertex_.resize(cuts_.size());
  first_at_.assign(vertices_ + 1, 0);
  for (const Curve_cut& c : cuts_) ++first_at_[c.vertex + 1];
  for (std::size_t v = 0; v < vertices_; ++v) first_at_[v + 1] += first_at_[v];
  std::vector<std::uint32_t> next(first_at_.begin(), first_at_.end() - 1);
  for (std::uint32_t c = 0; c < cuts_.size(); ++c) by_vertex_[next[cuts_[c].vertex]++] = c;
}

const Exact_parameter& Cut_curves::parameter(const Bracket& at, std::uint32_t cut) const {
  static const Exact_parameter ENDS[] = {Exact_parameter(Exact_rational(0)), Exact_parameter(Exact_rational(1))};
  return is_end_of_piece(at) ? ENDS[at.lower == 0 ? 0 : 1] : places_.parameter(cuts_[cut].place);
}

void Cut_curves::add_edges() {
  const auto& drawn = curves_.drawing().curves();
  after_.assign(cuts_.size(), NO_NUMBER);
  before_.assign(cuts_.size(), NO_NUMBER);
  edges_.reserve(cuts_.size() + drawn.size());
  for (std::uint32_t curve = 0; curve < drawn.size(); ++curve) {
    const std::uint32_t first = first_cut_[curve], end = first_cut_[curve + 1];
    first_edge_.push_back(static_cast<std::uint32_t>(edges_.size()));
    for (std::uint32_t c = first; c < end && (drawn[curve].is_closed || c + 1 < end); ++c) {
      const auto number = static_cast<std::uint32_t>(edges_.size());
      const std::uint32_t last = c + 1 < end ? c + 1 : first;
      after_[c] = number;
      before_[last] = number;
      edges_.push_back({curve, c, last, number});
    }
    if (first == end) {
      const auto number = static_cast<std::uint32_t>(edges_.size());
      edges_.push_back({curve, NO_NUMBER, NO_NUMBER, number});
    }
  }
}

std::uint32_t Cut_curves::edge_at(std::size_t curve, std::uint32_t cut_behind) const {
  const std::uint32_t first = first_cut_[curve], last = first_cut_[curve + 1];
  if (first == last) return first_edge_[curve];
  if (!curves_.drawing().curves()[curve].is_closed)
    return first_edge_[curve] + std::clamp(cut_behind, first + 1, last - 1) - 1 - first;
  return first_edge_[curve] + (cut_behind == first ? last - 1 : cut_behind - 1) - first;
}

std::vector<Bezier_span> Cut_curves::spans_of(std::uint32_t edge) const {
  const Cut_edge& e = edges_[edge];
  const std::uint32_t first = curves_.number_of_bezier(e.curve, 0),
                      end = curves_.number_of_bezier(e.curve, curves_.drawing().curves()[e.curve].beziers.size());
  std::vector<Bezier_span> spans;
  constexpr Bracket START{0, 0}, END{1, 1};
  if (e.first == NO_NUMBER) {
    for (std::uint32_t b = first; b < end; ++b) spans.push_back({b, START, END, NO_NUMBER, NO_NUMBER});
    return spans;
  }
  const Joint_place &from = cuts_[e.first].at, &to = cuts_[e.last].at;
  if (from.bezier == to.bezier && e.first < e.last) return {{from.bezier, from.t, to.t, e.first, e.last}};
  spans.push_back({from.bezier, from.t, END, e.first, NO_NUMBER});
  const auto next = [&](std::uint32_t b) { return b + 1 < end ? b + 1 : first; };
  for (std::uint32_t b = next(from.bezier); b != to.bezier; b = next(b))
    spans.push_back({b, START, END, NO_NUMBER, NO_NUMBER});
  if (to.is_start()) spans.back().last_cut = e.last;
  else spans.push_back({to.bezier, START, to.t, NO_NUMBER, e.last});
  return spans;
}

// The edges of an overlap, between two cuts of a curve: all of a closed one where these are the same.
std::vector<std::uint32_t> Cut_curves::edges_between(std::uint32_t from, std::uint32_t to) const {
  std::vector<std::uint32_t> result;
  std::uint32_t c = from;
  do {
    result.push_back(after_[c]);
    c = edges_[after_[c]].last;
  } while (c != to);
  return result;
}

void Cut_curves::join_edges() {
  next_member_.assign(edges_.size(), NO_NUMBER);
  // of sides, so that a class is two sets: sides to the left of its least edge, and those to the right of it
  Joined_sets sides(2 * edges_.size());
  for (std::size_t i = 0; i < places_.number_of_overlaps(); ++i) {
    Place_number p[4];  // a_from, b_from, a_to, b_to
    for (std::size_t k = 0; k < 4; ++k) p[k] = places_.overlap_place(i, k);
    if (is_point(places_.bezier_of(p[0])) || is_point(places_.bezier_of(p[1]))) continue;
    const std::optional<int> order = places_.compare(p[1], p[3]);
    if (!order) {
      undecided_ = p[1];
      return;
    }
    const bool runs_back = *order > 0;
    const auto a = edges_between(cut_of(p[0]), cut_of(p[2])),
               b = runs_back ? edges_between(cut_of(p[3]), cut_of(p[1])) : edges_between(cut_of(p[1]), cut_of(p[3]));
    if (a.size() != b.size())
      throw std::logic_error(expected("overlap of two curves", "the same cuts on both", "others"));
    for (std::size_t k = 0; k < a.size(); ++k)
      for (const bool is_right : {false, true})
        sides.join(side_of(a[k], is_right), side_of(runs_back ? b[b.size() - 1 - k] : b[k], is_right != runs_back));
  }
  for (auto e = static_cast<std::uint32_t>(edges_.size()); e-- > 0;) {
    const Edge_side least = sides.find(side_of(e, false));
    edges_[e].representative = edge_of(least);
    edges_[e].is_against = is_reversed(least);
    if (edges_[e].representative == e) continue;
    next_member_[e] = next_member_[edges_[e].representative];
    next_member_[edges_[e].representative] = e;
  }
  if (!curves_.drawing().curves().empty())
    for (std::uint32_t e = 0; e < edges_.size(); ++e)  // a point on other curves is no edge
      if (edges_[e].first != NO_NUMBER && edges_[e].first == edges_[e].last &&
          is_point(cuts_[edges_[e].first].at.bezier) && curves_.drawing().curves()[edges_[e].curve].beziers.size() == 1)
        edges_[e].representative = NO_NUMBER;
}

}  // namespace CGAL::Bounding_arcs::internal
