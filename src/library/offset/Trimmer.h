// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Trims a raw offset: all crossings, parts between them, and of those what is not covered.
//
//        e  |  f      Edges have what they are the offset of on their right.  Where f runs from the left of e to its
//         \ | /       right, it comes into e's band, and e leaves f's: what is left over is f before and e behind.
//     _____\|/____    So every crossing has one part that may end there and one that may begin there, and a part is
//           X         left over only if it begins as one that may, ends as one that may, and nothing else covers it.
//
// Whether it is covered is asked once, in its middle, as no part is covered partly.

#ifndef BOUNDING_ARCS_LIBRARY_OFFSET_TRIMMER_H
#define BOUNDING_ARCS_LIBRARY_OFFSET_TRIMMER_H

#include "Raw_offset.h"
#include "Source_arcs.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

[[nodiscard]] inline double squared_box_distance(const Xy<double>& q, const CGAL::Bbox_2& b) {
  const double dx = (std::max)((std::max)(b.xmin() - q.x, q.x - b.xmax()), 0.0),
               dy = (std::max)((std::max)(b.ymin() - q.y, q.y - b.ymax()), 0.0);
  return dx * dx + dy * dy;
}
/// How far inside a shape q is; negative outside.
[[nodiscard]] inline double depth_in(const Raw_shape& shape, const Xy<double>& q) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < shape.size; ++i) {
    const Xy<double>&p = shape.corners[i], side = shape.corners[(i + 1) % shape.size] - p;
    const double length = euclidean_norm(side);
    if (i == 1 && shape.radius > 0) least = (std::min)(least, shape.radius - euclidean_norm(q - shape.corners[0]));
    else if (length > 0) least = (std::min)(least, -cross(side, q - p) / length);
  }
  return least;
}

/// Which sides of a curve are offset.
struct Offset_sides {
  bool left, right;
};

/// Whether a point is nearer to the sources than the distance of an offset.
///
/// Where all joins and caps are round that is the distance to arcs.  Else what an offset takes is the union of the
/// normals of all arcs, as far as their centers, and of the shapes of joins and caps: only feet inside arcs count, and
/// only on sides that are offset.
class Cover {
 public:
  /// \param sides of the curves of the sources that are offset
  Cover(const Source_arcs& sources, double distance, const std::vector<Offset_sides>& sides,
        const std::vector<Raw_shape>& shapes, bool is_round)
      : sources_(sources), sides_(sides), shapes_(shapes), is_round_(is_round), distance_(distance) {
    if (is_round) return;
    std::vector<CGAL::Bbox_2> boxes;
    for (const Raw_shape& s : shapes) {
      CGAL::Bbox_2 box;
      for (std::size_t i = 0; i < s.size; ++i) {
        const Xy<double>& p = s.corners[i];
        box += CGAL::Bbox_2(p.x - s.radius, p.y - s.radius, p.x + s.radius, p.y + s.radius);
      }
      boxes.push_back(box);
    }
    tree_ = Box_tree(boxes);
  }

  [[nodiscard]] double distance() const { return distance_; }
  /// Whether q is covered, by more than a depth.
  [[nodiscard]] bool covers(const Xy<double>& q, double depth) const {
    const double reach = distance_ - depth;
    if (reach <= 0) return false;
    return any_near(sources_.blocks().tree(), q, reach * reach,
                    [&](std::uint32_t b) { return in_block(b, q, depth); }) ||
           (!is_round_ && any_near(tree_, q, 0, [&](std::uint32_t s) { return depth_in(shapes_[s], q) > depth; }));
  }

 private:
  // Whether one of the items has what is asked for whose boxes are no farther than the root of a square.
  template <class Has>
  [[nodiscard]] static bool any_near(const Box_tree& tree, const Xy<double>& q, double square, const Has& has) {
    const auto is_near = [&](const Box_tree::Node& node, std::size_t k) {
      return squared_distance(q, node, k) <= square;
    };
    return !for_each_item(tree, is_near,
                          [&](const Box_tree::Node& node, std::size_t k) { return !has(node.child[k]); });
  }
  [[nodiscard]] bool in_block(std::uint32_t number, const Xy<double>& q, double depth) const {
    const Arc_block& block = sources_.blocks().block(number);
    const double reach = distance_ - depth, most = reach * reach;
    const Offset_sides& sides = sides_[block.chain];
    for (std::uint32_t i = block.begin; i < block.end; ++i) {
      const Arc_2& arc = sources_.arcs[i].arc;
      if (squared_box_distance(q, box_about(arc)) >= most) continue;
      if (!is_round_ && !is_between_normals(q, arc, depth)) continue;
      const double away = signed_distance(q, arc);
      if (std::fabs(away) < reach && (is_round_ || (away > 0 ? sides.left : sides.right))) return true;
    }
    return false;
  }

  // By more than a depth: straight caps are on the normals of ends.
  [[nodiscard]] static bool is_between_normals(const Xy<double>& q, const Arc_2& arc, double depth) {
    const End_normals n = end_normals(arc);
    const Xy<double> t0{n.n0.y, -n.n0.x}, t1{n.n1.y, -n.n1.x};
    return dot(t0, q - arc.from) > depth && dot(t1, q - arc.to) < -depth;
  }

  const Source_arcs& sources_;
  const std::vector<Offset_sides>& sides_;
  const std::vector<Raw_shape>& shapes_;
  bool is_round_;
  double distance_;
  Box_tree tree_;
};

class Trimmer {
 public:
  /// \param room what rounding may move points by
  Trimmer(const Raw_offset& raw, const Cover& cover, double room)
      : raw_(raw), cover_(cover), room_(room), depth_(4 * raw.gap + room) {}

  /// \return whether everything fits together, and rounding decides nothing
  bool trim() {
    if (!find_crossings()) return false;
    for (const Raw_run& run : raw_.runs) add_parts(run);
    return link();
  }
  [[nodiscard]] std::vector<Raw_loop> loops() && { return std::move(loops_); }

 private:
  struct Event {
    std::uint32_t edge;
    double u;
    std::uint32_t crossing;
    bool enters;
    friend bool operator<(const Event& a, const Event& b) { return a.edge != b.edge ? a.edge < b.edge : a.u < b.u; }
  };
  struct Part {
    Event first, last;
    const Raw_run* run;
    bool is_used;
  };
  static constexpr std::uint32_t NONE = std::numeric_limits<std::uint32_t>::max();

  bool find_crossings() {
    std::vector<std::uint32_t> begins, run_of(raw_.edges.size());
    for (std::uint32_t r = 0; r < raw_.runs.size(); ++r) {
      begins.push_back(raw_.runs[r].begin);
      for (std::uint32_t i = raw_.runs[r].begin; i < raw_.runs[r].end; ++i) run_of[i] = r;
    }
    begins.push_back(static_cast<std::uint32_t>(raw_.edges.size()));
    const Arc_blocks blocks(
        begins, [&](std::uint32_t i) -> const Arc_2& { return raw_.edges[i].arc; },
        [&](std::uint32_t i) { return raw_.edges[i].turn; });
    const bool is_clear = blocks.for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      if (j < i) std::swap(i, j);
      const Raw_run& run = raw_.runs[run_of[i]];
      const bool are_neighbours =
          run_of[i] == run_of[j] && (j == i + 1 || (run.is_closed && i == run.begin && j + 1 == run.end));
      return are_neighbours || cross(i, j);
    });
    std::sort(events_.begin(), events_.end());
    return is_clear;
  }
  bool cross(std::uint32_t i, std::uint32_t j) {
    const Arc_crossings found = crossings(raw_.edges[i].arc, raw_.edges[j].arc, room_);
    for (int k = 0; k < found.count; ++k) {
      const Arc_crossing& c = found.at[k];
      const auto number = static_cast<std::uint32_t>(points_.size());
      points_.push_back(moebius_point(raw_.edges[j].arc, c.v));
      events_.push_back({i, c.u, number, !c.f_to_right});
      events_.push_back({j, c.v, number, c.f_to_right});
    }
    return !found.is_doubtful;
  }

  void add_parts(const Raw_run& run) {
    const auto at = [&](std::uint32_t edge) {
      return std::lower_bound(events_.begin(), events_.end(), Event{edge, -1, 0, false});
    };
    const auto begin = at(run.begin), end = at(run.end);
    if (begin == end) {
      if (run.is_closed && !is_covered(run, {run.begin, 0, NONE, false}, {run.end - 1, 1, NONE, false})) add_whole(run);
      return;
    }
    for (auto e = begin; e + 1 != end; ++e) add_part(run, *e, *(e + 1));
    if (run.is_closed) add_part(run, *(end - 1), *begin);
  }
  void add_whole(const Raw_run& run) {
    Raw_loop loop;
    loop.reserve(run.end - run.begin);
    for (std::uint32_t i = run.begin; i < run.end; ++i) loop.push_back({i, raw_.edges[i].arc, 0, 1});
    loops_.push_back(std::move(loop));
  }
  void add_part(const Raw_run& run, const Event& first, const Event& last) {
    if (first.enters || !last.enters || is_covered(run, first, last)) return;
    parts_.push_back({first, last, &run, false});
  }
  [[nodiscard]] bool is_covered(const Raw_run& run, const Event& first, const Event& last) const {
    const std::uint32_t ahead = edges_between(run, first, last), length = run.end - run.begin;
    std::uint32_t k = ahead / 2;  // of two edges the one with more of it
    if (ahead == 1 && last.u > 1 - first.u) k = 1;
    const std::uint32_t edge = run.begin + (first.edge - run.begin + k) % length;
    const double u = k == 0 ? first.u : 0, v = k == ahead ? last.u : 1;
    return cover_.covers(moebius_point(raw_.edges[edge].arc, (u + v) / 2), depth_);
  }

  bool link() {
    std::vector<std::uint32_t> from(points_.size(), NONE);  // the part that begins at a crossing
    for (std::uint32_t p = 0; p < parts_.size(); ++p) from[parts_[p].first.crossing] = p;
    for (std::uint32_t first = 0; first < parts_.size(); ++first) {
      if (parts_[first].is_used) continue;
      Raw_loop loop;
      std::uint32_t part = first;
      while (part != NONE && !parts_[part].is_used) {
        parts_[part].is_used = true;
        append(loop, parts_[part]);
        part = from[parts_[part].last.crossing];
      }
      if (part != first) return false;
      if (loop.empty()) continue;
      for (std::size_t i = 0; i < loop.size(); ++i) loop[i].arc.to = loop[(i + 1) % loop.size()].arc.from;
      loops_.push_back(std::move(loop));
    }
    return true;
  }
  // How many edges behind that of a the one of b is.
  [[nodiscard]] static std::uint32_t edges_between(const Raw_run& run, const Event& a, const Event& b) {
    const bool goes_round = b.edge < a.edge || (b.edge == a.edge && b.u < a.u);
    return goes_round ? run.end - run.begin - (a.edge - b.edge) : b.edge - a.edge;
  }
  void append(Raw_loop& loop, const Part& part) const {
    const Event &a = part.first, &b = part.last;
    const Raw_run& run = *part.run;
    const std::uint32_t ahead = edges_between(run, a, b), length = run.end - run.begin;
    for (std::uint32_t k = 0; k <= ahead; ++k)
      add_piece(loop, run.begin + (a.edge - run.begin + k) % length, k == 0 ? a.u : 0, k == ahead ? b.u : 1,
                k == 0 ? &a : nullptr, k == ahead ? &b : nullptr);
  }
  void add_piece(Raw_loop& loop, std::uint32_t edge, double u, double v, const Event* a, const Event* b) const {
    const Arc_2& arc = raw_.edges[edge].arc;
    const Xy<double> from = a != nullptr ? points_[a->crossing] : arc.from,
                     to = b != nullptr ? points_[b->crossing] : arc.to;
    if (!(v > u) || from == to) return;
    loop.push_back({edge, {from, to, bulge_between(arc, u, v)}, u, v});
  }

  const Raw_offset& raw_;
  const Cover& cover_;
  double room_, depth_;
  std::vector<Xy<double>> points_;
  std::vector<Event> events_;
  std::vector<Part> parts_;
  std::vector<Raw_loop> loops_;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
