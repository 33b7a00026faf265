// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of Bounding_parts.h.

#include "../overlay/Cut_curves.h"

#include "../query/Closest_search.h"
#include "../tree/Segment_hierarchy.h"
#include "Bounding_parts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

namespace CGAL::Bounding_arcs::internal {

namespace {

constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);

/// A part of a segment between two joints.
struct Wall {
  Spiral_piece_2 piece;
  std::uint32_t from, to;
  Side_windings windings;
  std::uint32_t same = NONE;  ///< the wall that stands for all that are one with it
  bool is_against = false;    ///< runs against that one
};
/// The side to the left of a wall, as it runs or against that.
using Wall_side = std::uint32_t;

class Wall_joiner {
 public:
  Wall_joiner(const Bounding_parts& parts, const std::vector<Side_windings>& windings,
              const std::vector<Wall_contact>& contacts, double close, const std::function<bool(int)>& is_inside,
              const std::function<int(const Xy<double>&)>& winding_at)
      : parts_(parts), curves_(parts.segments), close_(close), is_inside_(is_inside), winding_at_(winding_at),
        first_cut_joint_(static_cast<std::uint32_t>(2 * curves_.number_of_segments())),
        joints_(first_cut_joint_ + 2 * contacts.size()), is_touched_(first_cut_joint_ + 2 * contacts.size(), 0) {
    find_alone(contacts);
    cut(contacts);
    add_walls(windings);
    join_walls();
    find_sides();
    link();
    find_points();
  }

  [[nodiscard]] Bounding_parts joined() {
    std::vector<std::uint32_t> number(walls_.size(), NONE);
    std::vector<Segment_part> kept;
    std::vector<std::uint32_t> labels;  // by end
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      if (walls_[w].same != w || !(has_region(2 * w) || has_region(2 * w + 1))) continue;
      number[w] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(part(w));
      for (const std::uint32_t end : {walls_[w].from, walls_[w].to}) labels.push_back(joints_.find(end));
    }
    Bounding_parts result{curves_.parted(kept), {}, parts_.left_out, (std::max)(parts_.moved, moved_), {}};
    std::vector<char> is_done(2 * walls_.size(), 0);
    for (Wall_side first = 0; first < is_done.size(); ++first) {
      if (number[first / 2] == NONE || is_done[first] != 0 || !has_region(first)) continue;
      std::vector<Wall_side> sides;
      for (Wall_side s = first; s != NONE && is_done[s] == 0; s = next_[s]) {
        is_done[s] = 1;
        sides.push_back(s);
      }
      Bounding_ring ring;
      for (const Wall_side s : sides) ring.way.push_back({number[s / 2], s % 2 == 1});
      ring.is_outer = is_counterclockwise(sides);
      result.rings.push_back(std::move(ring));
    }
    result.number_joints(labels);
    return result;
  }

 private:
  struct Cut {
    double t;
    std::uint32_t joint;
  };
  [[nodiscard]] Xy<double> point(std::uint32_t segment, double t) const {
    return curves_.evaluator(curves_.bezier_of(segment))(t).point;
  }
  [[nodiscard]] std::uint32_t end_joint(std::uint32_t segment, bool is_last) const {
    return parts_.joints[2 * segment + is_last];
  }

  [[nodiscard]] bool is_short(std::uint32_t segment) const {
    const Spiral_piece_2 piece = curves_.piece(segment);
    return end_joint(segment, false) != end_joint(segment, true) &&
           euclidean_norm(piece.last.point - piece.first.point) <= 2 * close_;
  }
  // Segments without length are none, unless there is no other near: a dot stays the dot that it is.
  void find_alone(const std::vector<Wall_contact>& contacts) {
    const auto count = static_cast<std::uint32_t>(curves_.number_of_segments());
    Joined_sets near(first_cut_joint_);
    for (std::uint32_t s = 0; s < count; ++s)
      if (is_short(s)) near.join(end_joint(s, false), end_joint(s, true));
    const auto set_of = [&](std::uint32_t segment) { return near.find(end_joint(segment, false)); };
    std::vector<char> is_dot(first_cut_joint_, 1);
    for (std::uint32_t s = 0; s < count; ++s)
      if (!is_short(s)) is_dot[set_of(s)] = is_dot[near.find(end_joint(s, true))] = 0;
    for (const Wall_contact& c : contacts)
      if (set_of(c.a) != set_of(c.b)) is_dot[set_of(c.a)] = is_dot[set_of(c.b)] = 0;
    for (std::uint32_t s = 0; s < count; ++s) is_alone_.push_back(is_dot[set_of(s)]);
  }

  // Ends of contacts are joints: those of the segment where they are close to one.
  void cut(const std::vector<Wall_contact>& contacts) {
    cuts_.resize(curves_.number_of_segments());
    std::uint32_t next = first_cut_joint_;
    for (const Wall_contact& c : contacts) {
      if (is_alone_[c.a] != 0) continue;  // the other one is of the same dot
      const std::uint32_t a = cut_at(c.a, c.s, next), b = cut_at(c.b, c.t, next);
      joints_.join(a, b);
      contacted_.push_back(a);
    }
    for (std::uint32_t s = 0; s < cuts_.size(); ++s) {
      std::vector<Cut>& cuts = cuts_[s];
      std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.t < b.t; });
      std::vector<Cut> apart;
      for (const Cut& c : cuts) {
        if (!apart.empty() && euclidean_norm(point(s, c.t) - point(s, apart.back().t)) <= 2 * close_)
          joints_.join(c.joint, apart.back().joint);
        else apart.push_back(c);
      }
      cuts = std::move(apart);
    }
  }
  [[nodiscard]] std::uint32_t cut_at(std::uint32_t segment, double t, std::uint32_t& next) {
    const Spiral_piece_2 piece = curves_.piece(segment);
    const Xy<double> at = point(segment, t);
    for (const bool is_last : {false, true})
      if (euclidean_norm(at - (is_last ? piece.last : piece.first).point) <= 2 * close_)
        return end_joint(segment, is_last);
    cuts_[segment].push_back({t, next});
    return next++;
  }

  void add_walls(const std::vector<Side_windings>& windings) {
    for (std::uint32_t s = 0; s < cuts_.size(); ++s) {
      const Spiral_piece_2 whole = curves_.piece(s);
      first_wall_.push_back(static_cast<std::uint32_t>(walls_.size()));
      if (is_short(s) && is_alone_[s] == 0 && cuts_[s].empty()) {
        joints_.join(end_joint(s, false), end_joint(s, true));
        contacted_.push_back(end_joint(s, false));
      }
      Wall wall{{s, whole.first, whole.first}, end_joint(s, false), 0, windings[s]};
      const auto add = [&](const Spiral_sample& last, std::uint32_t to) {
        wall.piece.last = last, wall.to = to;
        wall.same = static_cast<std::uint32_t>(walls_.size());
        walls_.push_back(wall);
        wall.piece.first = last, wall.from = to;
      };
      for (const Cut& c : cuts_[s]) add(curves_.sample(s, c.t), c.joint);
      add(whole.last, end_joint(s, true));
    }
    first_wall_.push_back(static_cast<std::uint32_t>(walls_.size()));
    for (const std::uint32_t j : contacted_) is_touched_[joints_.find(j)] = 1;
  }

  [[nodiscard]] Xy<double> middle(const Wall& w) const {
    return point(w.piece.segment, 0.5 * (w.piece.first.t + w.piece.last.t));
  }
  // Walls between two joints that are close all along are one. What returns to its joint at once is none, but a point
  // that is alone there.
  void join_walls() {
    std::map<std::uint32_t, std::uint32_t> points;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> between;
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      Wall& wall = walls_[w];
      const std::uint32_t from = joints_.find(wall.from), to = joints_.find(wall.to);
      if (is_touched_[from] == 0 && is_touched_[to] == 0) continue;
      if (from == to) {
        const bool is_short = euclidean_norm(middle(wall) - wall.piece.first.point) <= 2 * close_;
        if (is_short) wall.same = NONE;
        if (is_short && wall.piece.first.point == wall.piece.last.point) points.emplace(from, w);
        continue;
      }
      std::vector<std::uint32_t>& others = between[std::minmax(from, to)];
      for (const std::uint32_t other : others) {
        const auto distance = distance_to(middle(wall), walls_[other]);
        if (!(distance <= 2 * close_)) continue;
        moved_ = (std::max)(moved_, distance);
        wall.same = other;
        wall.is_against = joints_.find(walls_[other].from) != from;
        break;
      }
      if (wall.same == w) others.push_back(w);
      else is_touched_[from] = is_touched_[to] = 1;
    }
    for (const Wall& wall : walls_)
      if (wall.same != NONE) points.erase(joints_.find(wall.from)), points.erase(joints_.find(wall.to));
    for (const auto& [joint, w] : points) walls_[w].same = w;
  }
  [[nodiscard]] double distance_to(const Xy<double>& q, const Wall& w) const {
    Closest_search search(curves_, q, 4 * close_);
    search.look_at(w.piece, curves_.region(w.piece));
    const auto found = search.result();
    return found ? euclidean_norm(found->point - q) : HUGE_VAL;
  }

  // Which sides of walls have a region, and what follows them: those in rings, but where walls are one.
  void find_sides() {
    has_region_.assign(2 * walls_.size(), 0);
    next_.assign(2 * walls_.size(), NONE);
    for (const Bounding_ring& ring : parts_.rings) {
      std::vector<Wall_side> sides;
      for (const Directed_segment& s : ring.way) {
        const std::uint32_t first = first_wall_[s.segment], end = first_wall_[s.segment + 1];
        for (std::uint32_t i = first; i < end; ++i)
          sides.push_back(s.is_reversed ? 2 * (end - 1 - (i - first)) + 1 : 2 * i);
      }
      for (std::size_t i = 0; i < sides.size(); ++i) {
        has_region_[sides[i]] = 1;
        next_[sides[i]] = sides[(i + 1) % sides.size()];
      }
    }
    std::map<std::uint32_t, std::vector<std::uint32_t>> others;  // by the wall that stands for them
    for (std::uint32_t w = 0; w < walls_.size(); ++w)
      if (walls_[w].same != NONE && walls_[w].same != w) others[walls_[w].same].push_back(w);
    for (const auto& [w, same] : others) {
      const Side_windings beyond = windings_beyond(w, same);
      has_region_[2 * w] = is_inside_(beyond.left) ? 1 : 0;
      has_region_[2 * w + 1] = is_inside_(beyond.right) ? 1 : 0;
    }
  }
  // Walls that are one have an order, from right to left, in which each begins with the number that the one before
  // ends with. That tells what is beyond the first and the last one, unless both are the same: then one is asked for.
  [[nodiscard]] Side_windings windings_beyond(std::uint32_t w, const std::vector<std::uint32_t>& same) const {
    std::map<int, int> steps;  // how many more begin with a number than end with it
    int all = 0;
    const auto add = [&](const Side_windings& s) { ++steps[s.right], --steps[s.left], all += s.left - s.right; };
    add(walls_[w].windings);
    for (const std::uint32_t o : same) {
      const Side_windings& s = walls_[o].windings;
      add(walls_[o].is_against ? Side_windings{s.right, s.left} : s);
    }
    if (all != 0)
      for (const auto& [number, count] : steps)
        if (count > 0) return {number + all, number};
    const bool is_first_inside = is_inside_(steps.begin()->first);
    const bool are_alike =
        std::all_of(steps.begin(), steps.end(), [&](const auto& s) { return is_inside_(s.first) == is_first_inside; });
    int number = steps.begin()->first;
    if (!are_alike) {
      constexpr double BESIDE = 16;  // times what is close
      const Spiral_piece_2& p = walls_[w].piece;
      const Spiral_sample m = curves_.sample(p.segment, 0.5 * (p.first.t + p.last.t));
      number = winding_at_(m.point + BESIDE * close_ * perp(m.tangent));
    }
    return {number, number};
  }
  [[nodiscard]] bool has_region(Wall_side s) const { return has_region_[s] != 0; }

  // Where walls were joined a ring goes on with the next wall clockwise, and elsewhere as it did.
  void link() {
    std::map<std::uint32_t, std::vector<Wall_side>> leaving;  // by touched joint
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      if (walls_[w].same != w) continue;
      const std::uint32_t from = joints_.find(walls_[w].from), to = joints_.find(walls_[w].to);
      if (is_touched_[from] != 0) leaving[from].push_back(2 * w);
      if (is_touched_[to] != 0) leaving[to].push_back(2 * w + 1);
    }
    for (auto& [joint, sides] : leaving) {
      sort(sides);
      const std::size_t n = sides.size();
      for (std::size_t i = 0; i < n; ++i) {
        std::uint32_t& next = next_[sides[i] ^ 1U];
        next = NONE;
        for (std::size_t k = 1; k <= n && next == NONE; ++k) {
          const Wall_side s = sides[(i + n - k) % n];
          if (has_region(s)) next = s;
        }
      }
    }
  }
  // Counterclockwise. Those that leave in about one direction are told apart where they are no longer close.
  void sort(std::vector<Wall_side>& sides) const {
    const auto angle = [&](Wall_side s) {
      const Spiral_piece_2& p = walls_[s / 2].piece;
      const Xy<double> way = s % 2 == 0 ? p.first.tangent : -p.last.tangent;
      return std::atan2(way.y, way.x);
    };
    std::vector<std::pair<double, Wall_side>> order;
    for (const Wall_side s : sides) order.emplace_back(angle(s), s);
    std::sort(order.begin(), order.end());
    constexpr double SAME = 0x1p-18, FULL = 6.283185307179586;
    for (std::size_t i = 0; i < order.size(); ++i) {  // a group across the cut of angles begins behind it
      if (order.front().first + FULL - order.back().first > SAME) break;
      order.front().first += FULL;
      std::rotate(order.begin(), order.begin() + 1, order.end());
    }
    for (std::size_t i = 1; i < order.size(); ++i)
      for (std::size_t k = i;
           k > 0 && order[k].first - order[k - 1].first < SAME && is_left_of(order[k - 1].second, order[k].second);
           --k) {
        std::swap(order[k - 1].second, order[k].second);
      }
    for (std::size_t i = 0; i < order.size(); ++i) sides[i] = order[i].second;
  }
  // Whether a is counterclockwise of b, which leave one joint in about one direction.
  [[nodiscard]] bool is_left_of(Wall_side a, Wall_side b) const {
    constexpr int MOST_HALVINGS = 60;
    double share = 1;
    bool is_left = false;
    for (int i = 0; i < MOST_HALVINGS; ++i, share /= 2) {
      const Spiral_piece_2& p = walls_[a / 2].piece;
      const double t =
          a % 2 == 0 ? p.first.t + share * (p.last.t - p.first.t) : p.last.t - share * (p.last.t - p.first.t);
      const Xy<double> q = point(p.segment, t);
      Closest_search search(curves_, q, HUGE_VAL);
      const Spiral_piece_2& other = walls_[b / 2].piece;
      search.look_at(other, curves_.region(other));
      const auto found = search.result();
      if (!found) break;
      const Curve_jet jet = curves_.evaluator(curves_.bezier_of(other.segment))(found->place.t);
      const double side = cross(b % 2 == 0 ? jet.first : -jet.first, q - found->point);
      const bool is_inside = found->place.t != other.first.t && found->place.t != other.last.t;
      if (!(euclidean_norm(q - found->point) > close_)) break;  // from here on nothing is told
      is_left = side > 0;
      if (is_inside) return is_left;
    }
    return is_left;
  }

  [[nodiscard]] bool is_counterclockwise(const std::vector<Wall_side>& sides) const {
    constexpr int STEPS = 8;
    std::vector<Xy<double>> points;
    for (const Wall_side s : sides) {
      const Spiral_piece_2& p = walls_[s / 2].piece;
      for (int k = 0; k < STEPS; ++k) {
        const double share = static_cast<double>(s % 2 == 0 ? k : STEPS - k) / STEPS;
        points.push_back(point(p.segment, p.first.t + share * (p.last.t - p.first.t)));
      }
    }
    double area = 0, length = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Xy<double> a = points[i] - points.front(), b = points[(i + 1) % points.size()] - points.front();
      area += cross(a, b) / 2;
      length += euclidean_norm(b - a);
    }
    return area > close_ / 16 * length;
  }

  // A joint is where a wall goes on through it, if one does.
  void find_points() {
    points_.resize(is_touched_.size());
    std::vector<char> is_through(is_touched_.size(), 0), is_known(is_touched_.size(), 0);
    for (std::uint32_t w = 0; w < walls_.size(); ++w) {
      if (walls_[w].same != w) continue;
      for (const bool is_last : {false, true}) {
        const std::uint32_t end = is_last ? walls_[w].to : walls_[w].from, joint = joints_.find(end);
        const bool is_cut = end >= first_cut_joint_;
        if (is_known[joint] != 0 && (is_through[joint] != 0 || !is_cut)) continue;
        is_known[joint] = 1, is_through[joint] = is_cut ? 1 : 0;
        points_[joint] = (is_last ? walls_[w].piece.last : walls_[w].piece.first).point;
      }
    }
  }
  // A wall, whose ends are moved to joints that are elsewhere.
  [[nodiscard]] Segment_part part(std::uint32_t w) {
    const Spiral_piece_2& piece = walls_[w].piece;
    Segment_part made{piece, curves_.error(piece.segment)};
    const Xy<double> by[] = {points_[joints_.find(walls_[w].from)] - piece.first.point,
                             points_[joints_.find(walls_[w].to)] - piece.last.point};
    const double most = (std::max)(euclidean_norm(by[0]), euclidean_norm(by[1]));
    constexpr double LEAST = 0x1p-48;  // of the size: less is rounding
    if (!(most > LEAST * curves_.drawing().coordinate_size()) || piece.first.t == piece.last.t) return made;
    moved_ = (std::max)(moved_, most);
    made.moved = moved(curves_.evaluator(curves_.bezier_of(piece.segment)).curve(), piece, by[0], by[1]);
    return made;
  }
  // Control point i of n moves by a + (i / n) b; so a point moves by a + l(t) b, where l is the same mean of i / n.
  [[nodiscard]] static Bezier_curve_2<double> moved(const Bezier_curve_2<double>& curve, const Spiral_piece_2& piece,
                                                    const Xy<double>& first, const Xy<double>& last) {
    const int n = curve.degree();
    std::vector<Xy<double>> points;
    for (int i = 0; i <= n; ++i) points.push_back({static_cast<double>(i) / n, 0});
    const Bezier_curve_2<double> mean(std::move(points), curve.weights());
    const double l0 = mean.point(piece.first.t).x, l1 = mean.point(piece.last.t).x;
    const Xy<double> b = (1 / (l1 - l0)) * (last - first), a = first - l0 * b;
    points = curve.control_points();
    for (int i = 0; i <= n; ++i) points[i] = points[i] + (a + (static_cast<double>(i) / n) * b);
    return Bezier_curve_2<double>(std::move(points), curve.weights());
  }

  const Bounding_parts& parts_;
  const Segment_hierarchy& curves_;
  double close_;
  const std::function<bool(int)>& is_inside_;
  const std::function<int(const Xy<double>&)>& winding_at_;
  std::uint32_t first_cut_joint_;
  Joined_sets joints_;
  std::vector<char> is_touched_;           // by joint
  std::vector<std::uint32_t> contacted_;   // joints
  std::vector<char> is_alone_;             // by segment
  std::vector<std::vector<Cut>> cuts_;     // by segment
  std::vector<Wall> walls_;                // segment by segment
  std::vector<std::uint32_t> first_wall_;  // by segment
  std::vector<char> has_region_;           // by side
  std::vector<Wall_side> next_;            // by side
  std::vector<Xy<double>> points_;         // by joint
  double moved_ = 0;
};

[[nodiscard]] bool has_short_part(const Segment_hierarchy& curves, double length) {
  for (std::uint32_t s = 0; s < curves.number_of_segments(); ++s) {
    const Xy<double> chord = curves.piece(s).last.point - curves.piece(s).first.point;
    if ((chord.x != 0 || chord.y != 0) && euclidean_norm(chord) <= length) return true;
  }
  return false;
}

}  // namespace

Bounding_parts with_close_walls_joined(Bounding_parts parts, const std::vector<Side_windings>& windings,
                                       const std::function<bool(int)>& is_inside,
                                       const std::function<int(const Xy<double>&)>& winding_at, double close) {
  constexpr double MOST = 4;  // times what is close
  const double most = MOST * close;
  constexpr double ROOM = 16;  // times an error: what is close and what is far are told by regions that are as wide
  for (std::uint32_t s = 0; s < parts.segments.number_of_segments(); ++s)
    close = (std::max)(close, ROOM * parts.segments.error(s));
  const std::vector<Wall_contact> contacts = wall_contacts(parts, close);
  if (contacts.empty() && !has_short_part(parts.segments, 2 * close)) return parts;
  Bounding_parts joined = Wall_joiner(parts, windings, contacts, close, is_inside, winding_at).joined();
  return joined.moved <= most ? joined : parts;  // a long row of close ends is no joint
}

}  // namespace CGAL::Bounding_arcs::internal
