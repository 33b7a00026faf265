// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Neighbours on one circle or line become one piece.
//
// Nothing goes through a center. The arc over a stretch of pieces has its ends and the point P half its way along: seen
// from P the ends are half of what the arc turns by apart, so its bulge is the tangent of half the angle between P -
// from and to - P.
//
// How far pieces are from it. The power of a point with regard to a circle, along another one, is a constant and a
// sinusoid. Over at most half a circle that is no larger than sqrt(2) times its largest value at start, middle and
// end: of f = a + b cos x + c sin x with |f| <= 1 at -pi/2, 0 and pi/2, |f(x)| <= cos x + sin x. Distances are powers
// over the diameter but for a share of distance over radius, at most an eighth here, so that 8/5 times the largest of
// the three distances bounds all. Pieces lead from one end to the other within that ring, so each point of the arc has
// one of theirs beside it.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../arc/arc_crossings.h"
#include "offset_chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace {

constexpr double ROOMS_OF_ONE_CIRCLE = 64;  // tips of cusps are cut off that wide, so that nothing is narrower
constexpr double TURN_OF_HALF_A_CIRCLE = 3.1415926535897932;

// Along the tangents there, as long as the chord.
[[nodiscard]] Xy<double> chord_along(const Arc_2& arc, double sign) {
  const Xy<double> chord = arc.to - arc.from;
  return (1 - arc.bulge * arc.bulge) * chord + (sign * 2 * arc.bulge) * perp(chord);
}

// Whether b, which starts where a ends, may be on the circle of a, without a root or a choice that is hard to foretell:
// all neighbours of an offset are asked. The side of its other end is half its distance from that circle times
// (1 + b^2) times the chord, about; where b is longer that errs by the square of how much more than a.
[[nodiscard]] bool goes_on(const Arc_2& a, const Arc_2& b, double width) {
  constexpr double SQUARE_OF_TWICE = 4;  // more than the half
  const double of_a = dot(a.to - a.from, a.to - a.from), of_b = dot(b.to - b.from, b.to - b.from),
               square = width * width;
  const double side = side_of_circle(b.to, a), most = (1 + a.bulge * a.bulge) * (of_a + of_b);
  if (side * side * of_a > SQUARE_OF_TWICE * square * (most * most)) return false;
  // bulges of what is straight are rounded to either side
  const bool is_one_way = (a.bulge > 0) == (b.bulge > 0) && (a.bulge < 0) == (b.bulge < 0);
  if (!is_one_way && !(a.bulge * a.bulge * of_a <= square && b.bulge * b.bulge * of_b <= square)) return false;
  // a blunt tip of a cusp, as wide as that, is across what leads to it
  const Xy<double> coming = chord_along(a, 1), going = chord_along(b, -1);
  return dot(coming, going) > std::fabs(cross(coming, going));
}
// Pieces of one curve are alike that are of one kind, and a line is like what leads it on to a miter's tip or a cap's
// corner.
[[nodiscard]] bool are_alike(const Offset::Piece& a, const Offset::Piece& b) {
  constexpr double STRAIGHT = 0x1p-40;  // bulges of what is straight are rounded
  const bool are_lines = std::fabs(a.arc.bulge) <= STRAIGHT && std::fabs(b.arc.bulge) <= STRAIGHT;
  const bool are_of_kind = a.kind == b.kind && a.is_round == b.is_round;
  return a.source.curve == b.source.curve &&
         (are_of_kind || (are_lines && (a.kind == Offset::Kind::CURVE) != (b.kind == Offset::Kind::CURVE)));
}
[[nodiscard]] bool goes_on(const Offset::Piece& a, const Offset::Piece& b, double width) {
  return are_alike(a, b) && goes_on(a.arc, b.arc, width);
}

// Some pieces in a row, by the length of the way along them.
class Piece_stretch {
 public:
  Piece_stretch(const Offset::Piece* begin, const Offset::Piece* end) : pieces_(begin, end), ways_{0} {
    for (const Offset::Piece& p : pieces_) {
      ways_.push_back(ways_.back() + length(p.arc));
      turn_ += 2 * p.arc.half_turn();
    }
  }
  // Arcs of at most half a circle each, as few as there may be.
  [[nodiscard]] std::size_t number_of_arcs() const {
    constexpr double NEARLY = 1 + 0x1p-20;
    return (std::max)(std::size_t(1),
                      static_cast<std::size_t>(std::ceil(std::fabs(turn_) / (NEARLY * TURN_OF_HALF_A_CIRCLE))));
  }

  // The stretch as so many pieces, and how far points were moved. \return none where that is more than width
  struct Result {
    std::vector<Offset::Piece> pieces;
    double moved = 0;
  };
  [[nodiscard]] std::optional<Result> as_arcs(std::size_t count, double width, double room) const {
    Result result;
    Offset::Piece from = at(0, room);
    for (std::size_t i = 0; i < count; ++i) {
      const double low = share(i, count), high = share(i + 1, count);
      const Offset::Piece to = at(high, room);
      Offset::Piece piece = from;
      piece.arc = arc_between(from.arc.from, to.arc.from, at((low + high) / 2, 0).arc.from, count, room);
      set_end(piece, i + 1 < count ? to : pieces_.back(), i + 1 == count);
      const double moved = farthest(piece.arc, low, high);
      if (!(moved <= width)) return std::nullopt;
      result.moved = (std::max)(result.moved, moved);
      result.pieces.push_back(piece);
      from = to;
    }
    if (count == 1) set_source(result.pieces.front());
    return result;
  }

 private:
  // A line that is led on is still that of its curve, but not all of it is at the distance.
  void set_source(Offset::Piece& piece) const {
    const auto is_of_curve = [](const Offset::Piece& p) { return p.kind == Offset::Kind::CURVE; };
    const auto first = std::find_if(pieces_.begin(), pieces_.end(), is_of_curve);
    if (first == pieces_.end()) return;
    const Offset::Piece& last = *std::find_if(pieces_.rbegin(), pieces_.rend(), is_of_curve);
    piece.kind = first->kind;
    piece.source = first->source;
    set_end(piece, last, true);
    const auto is_round = [](const Offset::Piece& p) { return p.is_round; };
    piece.is_round = std::all_of(pieces_.begin(), pieces_.end(), is_round);
  }
  [[nodiscard]] double share(std::size_t i, std::size_t count) const {
    return i == count ? ways_.back() : ways_.back() * (static_cast<double>(i) / static_cast<double>(count));
  }
  static void set_end(Offset::Piece& piece, const Offset::Piece& at, bool is_end) {
    piece.t_end = is_end ? at.t_end : at.source.t;
    const std::uint32_t bezier = is_end ? at.bezier_of_end() : at.source.bezier;
    piece.bezier_step = static_cast<std::int32_t>(bezier - piece.source.bezier);
  }
  // A piece that starts at a way along; at the end of one that is as near as rounding.
  [[nodiscard]] Offset::Piece at(double way, double room) const {
    const auto behind = std::upper_bound(ways_.begin(), ways_.end() - 1, way);
    const auto i = static_cast<std::size_t>(behind - ways_.begin()) - (behind == ways_.begin() ? 0 : 1);
    if (way >= ways_.back() - room) return with_start(pieces_.back(), 1);
    if (way - ways_[i] <= room) return with_start(pieces_[i], 0);
    if (i + 1 < pieces_.size() && ways_[i + 1] - way <= room) return with_start(pieces_[i + 1], 0);
    return with_start(pieces_[i], (way - ways_[i]) / (ways_[i + 1] - ways_[i]));
  }
  [[nodiscard]] static Offset::Piece with_start(Offset::Piece piece, double share) {
    if (share == 0) return piece;
    piece.arc.from = share == 1 ? piece.arc.to : point(piece.arc, share);
    if (share == 1) piece.source.bezier = piece.bezier_of_end();
    piece.source.t += share * (piece.t_end - piece.source.t);
    return piece;
  }
  [[nodiscard]] Arc_2 arc_between(const Xy<double>& from, const Xy<double>& to, const Xy<double>& middle,
                                  std::size_t count, double room) const {
    constexpr double STRAIGHT = 8;  // an arc that turns by x is x L / 8 high
    if (std::fabs(turn_) * ways_.back() <= STRAIGHT * room) return {from, to, 0};
    constexpr double ROUNDING = 0x1p-40;
    const double turn = std::fabs(turn_) / static_cast<double>(count);
    if (std::fabs(turn - TURN_OF_HALF_A_CIRCLE) <= ROUNDING) return {from, to, std::copysign(1.0, turn_)};
    const Xy<double> coming = middle - from, going = to - middle;
    const double bulge = cross(coming, going) / (euclidean_norm(coming) * euclidean_norm(going) + dot(coming, going));
    return {from, to, (std::max)(-1.0, (std::min)(1.0, bulge))};
  }
  // How far points of the pieces from one way to another are from the arc's circle at most.
  [[nodiscard]] double farthest(const Arc_2& arc, double low, double high) const {
    constexpr double OF_PIECE = 1.6, OF_RADIUS = 0x1p-3;
    double most = 0;
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (ways_[i + 1] <= low || ways_[i] >= high) continue;
      const Arc_2& of_piece = pieces_[i].arc;
      for (const Xy<double>& q : {of_piece.from, moebius_point(of_piece, 0.5), of_piece.to}) {
        const Arc_view<double> v = view(q, arc);
        most = (std::max)(most, std::fabs(distance_to_circle(v, v.apart, arc.bulge)));
      }
    }
    const double chord = euclidean_norm(arc.to - arc.from), b = std::fabs(arc.bulge);
    if (!(4 * b * most <= OF_RADIUS * (1 + b * b) * chord)) return HUGE_VAL;
    return OF_PIECE * (most + ARC_DISTANCE_ERROR * (chord + most));
  }

  std::vector<Offset::Piece> pieces_;
  std::vector<double> ways_;  // to their starts, and to the last one's end
  double turn_ = 0;
};

// Appends a stretch as few pieces, or its halves so.
void append_few(const Offset::Piece* begin, const Offset::Piece* end, double width, double room,
                std::vector<Offset::Piece>& pieces, double& moved) {
  const auto size = static_cast<std::size_t>(end - begin);
  if (size > 1) {
    const Piece_stretch stretch(begin, end);
    const std::size_t count = stretch.number_of_arcs();
    auto result = count < size ? stretch.as_arcs(count, width, room) : std::nullopt;
    if (result) {
      moved = (std::max)(moved, result->moved);
      pieces.insert(pieces.end(), result->pieces.begin(), result->pieces.end());
      return;
    }
    if (size > 2) {
      const Offset::Piece* middle = begin + size / 2;
      append_few(begin, middle, width, room, pieces, moved);
      append_few(middle, end, width, room, pieces, moved);
      return;
    }
  }
  pieces.insert(pieces.end(), begin, end);
}

struct Place_before {
  bool operator()(const Xy<double>& a, const Xy<double>& b) const { return a.x != b.x ? a.x < b.x : a.y < b.y; }
};

// Places between pieces that may be put together, but for those where other pieces end, too.
class Piece_joints {
 public:
  Piece_joints(const Offset& offset, double width) : width_(width) {
    for (const Offset::Chain& c : offset.chains)
      for (std::size_t i = c.is_closed ? 0 : 1; i < c.pieces.size(); ++i)
        if (goes_on(before(c, i), c.pieces[i], width)) places_.push_back(c.pieces[i].arc.from);
    if (places_.empty()) return;
    std::sort(places_.begin(), places_.end(), Place_before());
    count_.assign(places_.size(), 0);
    for (const Offset::Chain& c : offset.chains) {
      for (const Offset::Piece& p : c.pieces) count(p.arc.from);
      if (!c.is_closed) count(c.pieces.back().arc.to);
    }
  }
  [[nodiscard]] bool empty() const { return places_.empty(); }
  // Whether piece i goes on where the one before ends.
  [[nodiscard]] bool has(const Offset::Chain& chain, std::size_t i) const {
    if (i == 0 && !chain.is_closed) return false;
    const Xy<double>& place = chain.pieces[i].arc.from;
    const auto found = std::lower_bound(places_.begin(), places_.end(), place, Place_before());
    return found != places_.end() && *found == place &&
           count_[static_cast<std::size_t>(found - places_.begin())] == 1 &&
           goes_on(before(chain, i), chain.pieces[i], width_);
  }

 private:
  [[nodiscard]] static const Offset::Piece& before(const Offset::Chain& chain, std::size_t i) {
    return chain.pieces[i == 0 ? chain.pieces.size() - 1 : i - 1];
  }
  void count(const Xy<double>& place) {
    const auto found = std::lower_bound(places_.begin(), places_.end(), place, Place_before());
    if (found != places_.end() && *found == place) ++count_[static_cast<std::size_t>(found - places_.begin())];
  }

  double width_;
  std::vector<Xy<double>> places_;
  std::vector<unsigned> count_;  // of pieces that start there
};

// A closed chain has two pieces or more, and runs as it did.
bool may_become(const Offset::Chain& chain, const std::vector<Offset::Piece>& pieces) {
  return !chain.is_closed || (pieces.size() > 1 && (internal::size_of(pieces).area > 0) == chain.is_ccw);
}

double put_together(Offset::Chain& chain, const Piece_joints& joints, double width, double room) {
  const std::size_t n = chain.pieces.size();
  std::vector<char> is_joint(n);
  std::size_t first = n, count = 0;  // where something else begins
  for (std::size_t i = 0; i < n; ++i) {
    is_joint[i] = joints.has(chain, i);
    if (is_joint[i]) ++count;
    else if (first == n) first = i;
  }
  if (count == 0 || n < 2) return 0;
  if (first < n && chain.is_closed) {
    std::rotate(chain.pieces.begin(), chain.pieces.begin() + static_cast<std::ptrdiff_t>(first), chain.pieces.end());
    std::rotate(is_joint.begin(), is_joint.begin() + static_cast<std::ptrdiff_t>(first), is_joint.end());
  }
  std::vector<Offset::Piece> pieces;
  double moved = 0;
  for (std::size_t begin = 0, end = 0; begin < n; begin = end) {
    for (end = begin + 1; end < n && is_joint[end];) ++end;
    append_few(chain.pieces.data() + begin, chain.pieces.data() + end, width, room, pieces, moved);
  }
  if (pieces.size() == n || !may_become(chain, pieces)) return 0;
  if (chain.is_closed) chain.area = internal::size_of(pieces).area;
  chain.pieces = std::move(pieces);
  return moved;
}

}  // namespace

double put_together(Offset& offset, double most, double room) {
  const double width = (std::min)(most, ROOMS_OF_ONE_CIRCLE * room);
  const Piece_joints joints(offset, width);
  double moved = 0;
  if (joints.empty()) return moved;
  for (Offset::Chain& chain : offset.chains) moved = (std::max)(moved, put_together(chain, joints, width, room));
  return moved;
}

void make_few(Offset& offset, double eps, double room) {
  const auto together = [&] {  // what is beyond eps already is so by rounding, as is what is put together
    const double most = offset.error <= eps ? eps - offset.error : ROOMS_OF_ONE_CIRCLE * room;
    offset.error += put_together(offset, most, room);
  };
  together();
  if (!(offset.error < eps)) return;
  const double moved = leave_out_short(offset, eps, eps - offset.error, room);
  offset.error += moved;
  if (moved > 0) together();  // what was between two arcs of one circle may be gone
}

}  // namespace CGAL::Bounding_arcs
