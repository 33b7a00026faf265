// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which ends of open curves are joined: each end has one partner at most.
//
//   ends in cells of a grid -> pairs of which neither has a third one -> those that go on straight -> loops by order

#ifndef BOUNDING_ARCS_LIBRARY_CURVE_JOINTS_H
#define BOUNDING_ARCS_LIBRARY_CURVE_JOINTS_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Unit.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal::joints {

using Point = Xy<double>;
using Piece = Bezier_curve_2<double>;
using Curve = Drawing_2<double>::Curve;

inline constexpr std::size_t NO_END = std::numeric_limits<std::size_t>::max();

inline double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

// End 2 i is the start of curve i, 2 i + 1 the end of it.
inline std::size_t other_end(std::size_t end) { return end ^ 1; }

inline bool is_within(const std::vector<Piece>& pieces, const Point& start, double r) {
  return std::all_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    const auto& points = piece.control_points();
    return std::all_of(points.begin(), points.end(), [&](const Point& p) { return distance(p, start) <= r; });
  });
}

inline std::size_t end_behind(const Joined_curves::Part& part) { return 2 * part.curve + (part.is_reversed ? 0 : 1); }

inline std::vector<Piece> pieces_of(const Curve& curve, bool is_reversed) {
  if (!is_reversed) return curve.beziers;
  std::vector<Piece> pieces;
  for (auto piece = curve.beziers.rbegin(); piece != curve.beziers.rend(); ++piece) pieces.push_back(piece->reversed());
  return pieces;
}

// Whether nothing of a loop is left to be a curve: it is within its moves, or two curves one upon the other.
inline bool is_empty_loop(const std::vector<Curve>& curves, const std::vector<Joined_curves::Part>& loop,
                          double moved) {
  std::vector<Piece> pieces;
  for (const Joined_curves::Part& part : loop) {
    const std::vector<Piece> more = pieces_of(curves[part.curve], part.is_reversed);
    pieces.insert(pieces.end(), more.begin(), more.end());
  }
  if (is_within(pieces, pieces.front().control_points().front(), moved)) return true;
  if (loop.size() != 2) return false;
  const std::vector<Piece> one = pieces_of(curves[loop[0].curve], false),
                           two = pieces_of(curves[loop[1].curve], !loop[1].is_reversed);
  return std::equal(one.begin(), one.end(), two.begin(), two.end(), [&](const Piece& a, const Piece& b) {
    const auto &p = a.control_points(), &q = b.control_points();
    return a.weights() == b.weights() && std::equal(p.begin(), p.end(), q.begin(), q.end(),
                                                    [&](auto& s, auto& t) { return distance(s, t) <= moved; });
  });
}

// From the start of a piece to the next control point that is another one; 0 for a point.
inline Point arm(const Piece& piece) {
  const auto& points = piece.control_points();
  const auto next = std::find_if(points.begin(), points.end(), [&](const Point& p) { return p != points.front(); });
  return next == points.end() ? Point{0, 0} : *next - points.front();
}

// How far apart two ends may be that meet: by as much for all, and what their own curves add where that counts.
struct Reach {
  double of_all;
  const std::vector<double>* of_curves = nullptr;

  [[nodiscard]] double between(std::size_t a, std::size_t b) const {
    return of_curves == nullptr ? of_all : of_all + (*of_curves)[a / 2] + (*of_curves)[b / 2];
  }
  [[nodiscard]] double widest() const {
    return of_curves == nullptr ? of_all : of_all + 2 * *std::max_element(of_curves->begin(), of_curves->end());
  }
};

// Ends that are free, in cells of a grid: those within a distance are in the cells around.
class Free_ends {
 public:
  // \param least cell: numbers of cells have to be exact
  Free_ends(double reach, double least) : reach_(reach), cell_((std::max)(reach, least)) {}

  void add(std::size_t end, const Point& p) { cells_[cell_of(p)].push_back({end, p}); }
  // Up to two others that are within reach and are wanted.
  template <class Is_wanted>
  [[nodiscard]] std::vector<std::size_t> beside(std::size_t end, const Point& p, const Is_wanted& is_wanted) const {
    std::vector<std::size_t> found;
    const Cell cell = cell_of(p);
    for (const double dx : {0, -1, 1})
      for (const double dy : {0, -1, 1}) {
        const auto place = cells_.find({cell.first + dx, cell.second + dy});
        if (place == cells_.end()) continue;
        for (const Free_end& other : place->second) {
          if (other.end == end || !(distance(other.place, p) <= reach_) || !is_wanted(other.end)) continue;
          found.push_back(other.end);
          if (found.size() == 2) return found;
        }
      }
    return found;
  }

 private:
  using Cell = std::pair<double, double>;
  struct Free_end {
    std::size_t end;
    Point place;
  };
  [[nodiscard]] Cell cell_of(const Point& p) const { return {std::floor(p.x / cell_), std::floor(p.y / cell_)}; }

  double reach_, cell_;
  std::map<Cell, std::vector<Free_end>> cells_;
};

// Which ends become one.
class Joints {
 public:
  Joints(const Drawing_2<double>& drawing, const std::vector<std::size_t>& layers)
      : curves_(drawing.curves()), layers_(layers), size_(drawing.coordinate_size()),
        partner_(2 * curves_.size(), NO_END) {}

  // Joins loops whose curves follow each other in the drawing, on one layer, where tangents tell nothing else. Outlines
  // are drawn so, and where several touch, in one direction even, only that tells them apart. It tells nothing of a
  // place where another curve ends that is in no such loop: there two curves may follow each other by chance.
  void join_loops_within(const Reach& reach) {
    const Free_ends ends = free_ends(reach);
    std::vector<std::vector<Joined_curves::Part>> loops;
    std::vector<char> is_in_loop(partner_.size(), 0);  // ends
    const auto mark = [&](const std::vector<Joined_curves::Part>& loop, char is_in) {
      for (const Joined_curves::Part& part : loop) is_in_loop[2 * part.curve] = is_in_loop[2 * part.curve + 1] = is_in;
    };
    for (std::size_t first = 0, next = 1; first < curves_.size(); first = next++) {
      for (const bool is_reversed : {false, true}) {
        std::vector<Joined_curves::Part> run{{first, is_reversed}};
        const bool is_loop = goes_round(run, reach);
        next = (std::max)(next, first + run.size());
        if (!is_loop) continue;
        if (is_told_by_order(run, ends, reach)) {
          mark(run, 1);
          loops.push_back(std::move(run));
        }
        break;
      }
    }
    const auto is_beside_others = [&](const std::vector<Joined_curves::Part>& loop) {
      return std::any_of(loop.begin(), loop.end(), [&](const Joined_curves::Part& part) {
        const auto is_other = [&](std::size_t other) { return is_in_loop[other] == 0; };
        const auto any = [](std::size_t, std::size_t) { return true; };
        for (const std::size_t end : {2 * part.curve, 2 * part.curve + 1}) {
          const auto found = beside(ends, end, reach, !layers_.empty(), any);
          if (std::any_of(found.begin(), found.end(), is_other)) return true;
        }
        return false;
      });
    };
    for (bool is_any = true; is_any;) {  // a loop that is left out may be beside others
      const auto kept =
          std::stable_partition(loops.begin(), loops.end(), [&](const auto& loop) { return !is_beside_others(loop); });
      is_any = kept != loops.end();
      std::for_each(kept, loops.end(), [&](const auto& loop) { mark(loop, 0); });
      loops.erase(kept, loops.end());
    }
    for (const std::vector<Joined_curves::Part>& loop : loops)
      for (std::size_t i = 0; i < loop.size(); ++i) join(end_behind(loop[i]), begin_behind(loop, i));
  }
  // Joins what has one other end within reach that has no third one.
  void join_within(const Reach& reach, bool is_of_one_layer) {
    join_only(
        reach, is_of_one_layer, [](std::size_t, std::size_t) { return true; },
        [](std::size_t, std::size_t) { return true; });
  }
  // Joins what goes on straight in one other end within reach, where no third one nearly does. Whether there was any.
  bool join_straight_within(const Reach& reach, bool is_of_one_layer) {
    return join_only(
        reach, is_of_one_layer, [&](std::size_t a, std::size_t b) { return is_nearly_straight(a, b, reach); },
        [&](std::size_t a, std::size_t b) { return is_straight(a, b, reach); });
  }
  // Closes chains whose own two ends are within reach, whatever else ends there.
  void close_within(const Reach& reach) {
    for_each_free([&](std::size_t end) {
      std::size_t last = other_end(end);
      while (partner_[last] != NO_END) last = other_end(partner_[last]);
      const double gap = distance(place(end), place(last));
      if (!(gap <= reach.between(end, last)) || is_chain_within(end, gap)) return;
      join(end, last);
    });
  }
  // Where ends are left apart, as more than two meet.
  [[nodiscard]] std::vector<Point> crowded(const Reach& reach) const {
    const Free_ends ends = free_ends(reach);
    Free_ends told(reach.widest(), least_cell());
    std::vector<Point> places;
    for_each_free([&](std::size_t end) {
      if (beside(ends, end, reach, false, [](std::size_t, std::size_t) { return true; }).size() < 2) return;
      if (told.beside(NO_END, place(end), [](std::size_t) { return true; }).empty()) places.push_back(place(end));
      told.add(end, place(end));
    });
    return places;
  }

  [[nodiscard]] std::size_t partner(std::size_t end) const { return partner_[end]; }
  void part(std::size_t end) {
    partner_[partner_[end]] = NO_END;
    partner_[end] = NO_END;
  }
  [[nodiscard]] double gap(std::size_t end) const { return distance(place(end), place(partner_[end])); }
  [[nodiscard]] const Point& place(std::size_t end) const {
    const auto& pieces = curves_[end / 2].beziers;
    return end % 2 == 0 ? pieces.front().control_points().front() : pieces.back().control_points().back();
  }

 private:
  [[nodiscard]] double least_cell() const {
    return (std::max)(std::ldexp(size_, -44), std::numeric_limits<double>::min());
  }
  void join(std::size_t a, std::size_t b) {
    partner_[a] = b;
    partner_[b] = a;
  }
  // Whether two ends are joined, or may be.
  [[nodiscard]] bool meet(std::size_t a, std::size_t b, const Reach& reach) const {
    if (partner_[a] != NO_END || partner_[b] != NO_END) return partner_[a] == b;
    return distance(place(a), place(b)) <= reach.between(a, b);
  }
  // Adds the curves behind the first one of a run, as long as each begins where the one before it ends, up to one that
  // ends where the run begins. Whether there is such a one.
  bool goes_round(std::vector<Joined_curves::Part>& run, const Reach& reach) const {
    const std::size_t begin = other_end(end_behind(run.front()));
    if (curves_[begin / 2].is_closed || meet(begin, other_end(begin), reach)) return false;
    for (std::size_t next = begin / 2 + 1; next < curves_.size(); ++next) {
      if (curves_[next].is_closed || (!layers_.empty() && layers_[next] != layers_[begin / 2])) return false;
      const std::size_t end = end_behind(run.back());
      const bool is_reversed = meet(end, 2 * next + 1, reach);
      if (is_reversed == meet(end, 2 * next, reach)) return false;
      run.push_back({next, is_reversed});
      if (meet(end_behind(run.back()), begin, reach)) return !is_empty_loop(curves_, run, reach.widest());
    }
    return false;
  }

  [[nodiscard]] static std::size_t begin_behind(const std::vector<Joined_curves::Part>& loop, std::size_t i) {
    return other_end(end_behind(loop[(i + 1) % loop.size()]));
  }
  // Whether no end of a loop goes on straight in another one.
  [[nodiscard]] bool is_told_by_order(const std::vector<Joined_curves::Part>& loop, const Free_ends& ends,
                                      const Reach& reach) const {
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (goes_elsewhere(ends, end_behind(loop[i]), begin_behind(loop, i), reach) ||
          goes_elsewhere(ends, begin_behind(loop, i), end_behind(loop[i]), reach))
        return false;
    return true;
  }

  // How far the way through two ends is from a straight one: 2 at most, and less certain where ends were moved.
  struct Bend {
    double size, turn;  // turn: by how much it changes where both ends are moved by 1
    [[nodiscard]] double at_least(double reach) const { return size - turn * reach / 2; }
    [[nodiscard]] double at_most(double reach) const { return size + turn * reach / 2; }
  };
  [[nodiscard]] Bend bend(std::size_t a, std::size_t b) const {
    const Point u = arm_at(a), v = arm_at(b);
    const double p = distance(u, {0, 0}), q = distance(v, {0, 0});
    if (p == 0 || q == 0) return {2, 0};
    return {distance(1 / p * u, -1 / q * v), 1 / p + 1 / q};
  }
  // Tangents in files are rounded, and arcs are drawn by eye: a quarter of the angle would leave some apart. Twice as
  // much would take corners for none.
  static constexpr double STRAIGHT = 0x1p-6, NEARLY = 4 * STRAIGHT;  // radians
  [[nodiscard]] bool is_nearly_straight(std::size_t a, std::size_t b, const Reach& reach) const {
    return bend(a, b).at_least(reach.between(a, b)) <= NEARLY;
  }
  [[nodiscard]] bool is_straight(std::size_t a, std::size_t b, const Reach& reach) const {
    return bend(a, b).at_most(reach.between(a, b)) <= STRAIGHT;
  }
  // Whether a free end goes on straight in one that is not the one given, and no third one nearly does.
  [[nodiscard]] bool goes_elsewhere(const Free_ends& ends, std::size_t end, std::size_t given,
                                    const Reach& reach) const {
    if (partner_[end] != NO_END) return false;
    const auto may = [&](std::size_t a, std::size_t b) {
      return partner_[b] == NO_END && is_nearly_straight(a, b, reach);
    };
    const auto found = beside(ends, end, reach, !layers_.empty(), may);
    if (found.size() != 1 || found.front() == given || !is_straight(end, found.front(), reach)) return false;
    return beside(ends, found.front(), reach, !layers_.empty(), may) == std::vector<std::size_t>{end};
  }
  [[nodiscard]] Point arm_at(std::size_t end) const {
    const auto& pieces = curves_[end / 2].beziers;
    return arm(end % 2 == 0 ? pieces.front() : pieces.back().reversed());
  }

  // Joins ends of which each is the only one that the other may be joined to, if it should. Whether there was any.
  template <class May, class Should>
  bool join_only(const Reach& reach, bool is_of_one_layer, const May& may, const Should& should) {
    const Free_ends ends = free_ends(reach);
    std::vector<std::size_t> only(partner_.size(), NO_END);
    for_each_free([&](std::size_t end) {
      const auto found = beside(ends, end, reach, is_of_one_layer, may);
      if (found.size() == 1) only[end] = found.front();
    });
    bool is_any = false;
    for (std::size_t end = 0; end < only.size(); ++end) {
      const std::size_t other = only[end];
      if (other == NO_END || end > other || only[other] != end || !should(end, other)) continue;
      join(end, other);
      is_any = true;
    }
    return is_any;
  }
  template <class Action> void for_each_free(const Action& action) const {
    for (std::size_t end = 0; end < partner_.size(); ++end)
      if (partner_[end] == NO_END && !curves_[end / 2].is_closed) action(end);
  }
  [[nodiscard]] Free_ends free_ends(const Reach& reach) const {
    Free_ends ends(reach.widest(), least_cell());
    for_each_free([&](std::size_t end) { ends.add(end, place(end)); });
    return ends;
  }
  [[nodiscard]] bool is_chain_within(std::size_t end, double r) const {
    for (std::size_t at = end; at != NO_END; at = partner_[other_end(at)])
      if (!is_within(curves_[at / 2].beziers, place(end), r)) return false;
    return true;
  }
  // A curve no larger than its gap would become a point, and is not closed.
  template <class May>
  [[nodiscard]] std::vector<std::size_t> beside(const Free_ends& ends, std::size_t end, const Reach& reach,
                                                bool is_of_one_layer, const May& may) const {
    return ends.beside(end, place(end), [&](std::size_t other) {
      if (!(distance(place(end), place(other)) <= reach.between(end, other))) return false;
      if (other == other_end(end))
        return !is_within(curves_[end / 2].beziers, place(end), distance(place(end), place(other)));
      return (!is_of_one_layer || layers_[other / 2] == layers_[end / 2]) && may(end, other);
    });
  }

  const std::vector<Curve>& curves_;
  const std::vector<std::size_t>& layers_;
  double size_;
  std::vector<std::size_t> partner_;
};

}  // namespace CGAL::Bounding_arcs::internal::joints

#endif
