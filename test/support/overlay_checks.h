// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All that holds of what a Boolean operation makes of two drawings, whatever these are: the first thing that does not
// is thrown as a fault, so that long runs can count them.

#ifndef BOUNDING_ARCS_TEST_OVERLAY_CHECKS_H
#define BOUNDING_ARCS_TEST_OVERLAY_CHECKS_H

#include "combined_drawings.h"
#include "exact_windings.h"

#include <CGAL/Bounding_arcs_2/curve/Unit.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounding_arcs_test {

/// How far rounding moves the curve of a part, at most. In units of the roundings of coordinates, 2^-53 of the largest
/// one: two splits have 3 for each step, 18 for a cubic, and 36 where weights are blended, too; a place that is a
/// double away is 3 control polygons long times 2 roundings; the ends take one each.
inline double moved_by_rounding(const ba::Outline_2::Part& part, const Bezier& source) {
  constexpr double ROUNDINGS = 64;
  double size = 0, step = 0, least = source.weight(0), most = least;
  const auto& p = source.control_points();
  for (std::size_t i = 0; i < p.size(); ++i) {
    size = (std::max)({size, std::fabs(p[i].x), std::fabs(p[i].y)});
    if (i > 0) step = (std::max)({step, std::fabs(p[i].x - p[i - 1].x), std::fabs(p[i].y - p[i - 1].y)});
    least = (std::min)(least, source.weight(static_cast<int>(i)));
    most = (std::max)(most, source.weight(static_cast<int>(i)));
  }
  const double speed = 2 * source.degree() * step * (most / least),
               width = (std::max)(part.from.width(), part.to.width());
  return ROUNDINGS * 0x1p-53 * size + speed * width;
}

/// The longer side of a box of all control points.
inline double extent_of(const Drawing& drawing) {
  if (drawing.curves().empty()) return 0;
  const CGAL::Bbox_2 box = box_of(drawing);
  return (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin());
}

/// Points that were asked about, and those of them that were left out as rounding may move a curve past them.
struct Asked_points {
  std::size_t asked = 0, left_out = 0;
};

/// An outline beside what it is to be. Whatever is wrong is thrown as a Fault.
class Checked_outline {
 public:
  Checked_outline(const Drawing& a, const Drawing& b, const Operation& how, const Combined& made)
      : operands_{&a, &b}, how_(how), made_(made), whole_(operands_) {
    check_chains();
    note_depths();
    note_pieces();
  }

  void check(std::mt19937& random, Asked_points& asked) const {
    check_orientations();
    check_vertices();
    check_crossings();
    check_drawn(random, asked);
    for (int i = 0; i < 12; ++i) check_rounded(random_point(random), random, asked);
    for (int i = 0; i < 12; ++i) check_beside_vertex(random, asked);
    for (int i = 0; i < 6; ++i) check_beside_curve(random);
    for (int i = 0; i < 4; ++i) check_beside_part(random);
  }
  /// Whether a point is so near to a rounded curve that it may be on the wrong side.
  /// \param error of the point
  [[nodiscard]] bool is_near_rounded(const Point& q, double error = 0) const {
    return std::any_of(pieces_.begin(), pieces_.end(), [&](const Rounded_piece& p) { return p.is_near(q, error); });
  }
  /// How much area is between the rounded curves and the exact ones, at most.
  [[nodiscard]] double swept() const {
    double sum = 0;
    for (const Rounded_piece& p : pieces_) sum += p.swept;
    return sum;
  }
  /// The same for what is drawn without slivers: a curve that is moved by d passes over twice d times its length.
  [[nodiscard]] double swept_by_drawing() const {
    const double moved = made_.drawn.moved;
    double sum = swept();
    for (const Rounded_piece& p : pieces_) sum += 2 * moved * (p.swept / p.room + 2 * moved);
    return sum;
  }
  /// The area of the exact outline.
  [[nodiscard]] ba::Bracket area(double eps) const {
    if (pieces_.empty()) return {0, 0};
    const auto bounds = ba::area(ba::Bounding_arc_tree_2(made_.rounded), eps);
    return {bounds.lower - swept(), bounds.upper + swept()};
  }
  /// A point about where the operands are.
  [[nodiscard]] Point random_point(std::mt19937& random) const {
    if (whole_.size() == 0) return {0, 0};
    const CGAL::Bbox_2 box = box_of(*operands_[0]) + box_of(*operands_[1]);
    std::uniform_real_distribution<double> share(-0.05, 1.05);
    const double x = share(random);
    return {box.xmin() + x * (box.xmax() - box.xmin()), box.ymin() + share(random) * (box.ymax() - box.ymin())};
  }

 private:
  // A part as it was rounded.
  struct Rounded_piece {
    Bezier curve;
    CGAL::Bbox_2 box;
    double room;   // how far the exact one is from it, at most
    double swept;  // the area between the two, at most

    /// \param error of the point
    [[nodiscard]] bool is_near(const Point& q, double error = 0) const {
      const double most = room + error;
      if (q.x < box.xmin() - most || q.x > box.xmax() + most || q.y < box.ymin() - most || q.y > box.ymax() + most)
        return false;
      constexpr double DOT = 0x1p-400;  // of a point's coordinates: a piece is as near as its box is
      if ((std::max)(std::fabs(box.xmax()), std::fabs(box.ymax())) < DOT * (std::max)(std::fabs(q.x), std::fabs(q.y)) &&
          (std::max)(std::fabs(box.xmin()), std::fabs(box.ymin())) < DOT * (std::max)(std::fabs(q.x), std::fabs(q.y)))
        return true;
      return ba::closest_point(ba::Bounding_arc_tree_2(drawing_of(curve)), q)->distance.lower <= most;
    }
  };

  [[nodiscard]] const Bezier& source(const ba::Outline_2::Part& p) const {
    return operands_.at(p.operand)->curves().at(p.curve).beziers.at(p.bezier);
  }
  [[nodiscard]] static std::string at(const Point& q) {
    std::ostringstream text;
    text.precision(17);
    text << " at " << q.x << ' ' << q.y;
    return text.str();
  }

  void check_chains() const {
    const auto& chains = made_.outline.chains;
    if (made_.rounded.curves().size() != chains.size()) throw Fault("chains", "not one curve a chain");
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const auto& parts = chains[c].parts;
      const auto& curve = made_.rounded.curves()[c];
      if (parts.empty()) throw Fault("chains", "a chain without parts");
      if (!curve.is_closed) throw Fault("chains", "an open curve");
      for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].end != parts[(i + 1) % parts.size()].start) throw Fault("chains", "a gap" + at(parts[i].end));
        if (parts[i].operand > 1) throw Fault("chains", "a part of no operand");
        const ba::Bracket &low = is_reversed(parts[i]) ? parts[i].to : parts[i].from,
                          &high = is_reversed(parts[i]) ? parts[i].from : parts[i].to;
        if (!(0 <= low.lower && low.lower <= low.upper && high.lower <= high.upper && high.upper <= 1 &&
              low.lower <= high.upper))
          throw Fault("chains", "a part with a wrong range" + at(parts[i].start));
      }
      check_places(parts);
    }
  }
  // Parts end at one rounded vertex, which may have been computed from either.
  [[nodiscard]] std::vector<double> rooms_of(const std::vector<ba::Outline_2::Part>& parts) const {
    std::vector<double> own, rooms;
    for (const auto& part : parts) own.push_back(moved_by_rounding(part, source(part)));
    for (std::size_t i = 0, n = own.size(); i < n; ++i)
      rooms.push_back((std::max)({own[(i + n - 1) % n], own[i], own[(i + 1) % n]}));
    return rooms;
  }
  void check_places(const std::vector<ba::Outline_2::Part>& parts) const {
    const std::vector<double> rooms = rooms_of(parts);
    const auto check = [&](std::size_t i, const ba::Bracket& t, const Point& q) {
      const Point away = source(parts[i]).point(t.middle()) - q;
      if (std::hypot(away.x, away.y) > rooms[i]) throw Fault("chains", "a vertex beside its place" + at(q));
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
      check(i, parts[i].from, parts[i].start);
      check(i, parts[i].to, parts[i].end);
    }
  }
  // How many chains are around each.
  void note_depths() {
    const auto& chains = made_.outline.chains;
    for (const auto& chain : chains) {
      std::size_t depth = 0;
      for (auto p = chain.parent; p; p = chains[*p].parent) {
        if (*p >= chains.size()) throw Fault("nesting", "a parent that is not there");
        if (++depth > chains.size()) throw Fault("nesting", "parents in a cycle");
      }
      if (chain.is_ccw != (depth % 2 == 0)) throw Fault("nesting", "a chain that runs round as its parent does");
      depth_.push_back(depth);
    }
  }
  void note_pieces() {
    for (std::size_t c = 0; c < made_.outline.chains.size(); ++c) {
      const auto& beziers = made_.rounded.curves()[c].beziers;
      const auto& parts = made_.outline.chains[c].parts;
      chains_.emplace_back(drawing_of(beziers));
      // an outline may leave out parts whose rounded ends coincide: then all have the room of the largest
      const std::vector<double> rooms = rooms_of(parts);
      const double most = *std::max_element(rooms.begin(), rooms.end());
      for (std::size_t i = 0; i < beziers.size(); ++i) {
        const double room = beziers.size() == parts.size() ? rooms[i] : most;
        CGAL::Bbox_2 box;
        double length = 0;
        const auto& p = beziers[i].control_points();
        for (std::size_t k = 0; k < p.size(); ++k) {
          box += CGAL::Bbox_2(p[k].x, p[k].y, p[k].x, p[k].y);
          if (k > 0) length += std::hypot(p[k].x - p[k - 1].x, p[k].y - p[k - 1].y);
        }
        pieces_.push_back({beziers[i], box, room, 2 * room * (length + 2 * room)});
        chain_of_piece_.push_back(c);
      }
    }
  }
  void check_orientations() const {
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      double swept = 0, length = 0;
      for (std::size_t i = 0; i < pieces_.size(); ++i)
        if (chain_of_piece_[i] == c) {
          swept += pieces_[i].swept;
          length += pieces_[i].swept / pieces_[i].room;
        }
      const auto area = ba::area(chains_[c], 1e-6 * length * length);
      const bool is_ccw = made_.outline.chains[c].is_ccw;
      if (is_ccw ? area.upper < -swept : area.lower > swept) throw Fault("orientation", "another sign of the area");
    }
  }
  // Vertices of a chain are inside the one around it, or on it.
  void check_vertices() const {
    constexpr std::size_t MOST = 8;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const auto& chain = made_.outline.chains[c];
      if (!chain.parent) continue;
      const ba::Point_location_2 location(chains_[*chain.parent]);
      const std::vector<double> rooms = rooms_of(chain.parts);
      for (std::size_t i = 0; i < (std::min)(MOST, rooms.size()); ++i) {
        const Point& q = chain.parts[i].start;
        const auto w = location.winding_number(q);
        if (w.state != ba::Winding_number::State::DECIDED || w.number != 0) continue;
        bool is_near = false;
        for (std::size_t k = 0; k < pieces_.size(); ++k)
          is_near = is_near || (chain_of_piece_[k] == *chain.parent && pieces_[k].is_near(q, rooms[i]));
        if (!is_near) throw Fault("nesting", "a vertex outside of the parent" + at(q));
      }
    }
  }
  void check_crossings() const {
    if (const auto crossing = crossing_of_parts(made_.outline, operands_))
      throw Fault("crossing", "two parts cross" + at(*crossing));
  }

  // A point on a curve is no point to ask about: none.
  [[nodiscard]] std::optional<bool> is_inside(const std::vector<Seen_piece>& seen) const {
    const auto a = whole_.winding(0, seen), b = whole_.winding(1, seen);
    if (!a || !b) return std::nullopt;
    return how_.is_filled(*a, *b);
  }
  /// \param windings of each chain
  void check_windings(const std::vector<int>& windings, bool is_inside, const char* kind,
                      const std::string& where) const {
    const auto& chains = made_.outline.chains;
    int sum = 0;
    std::vector<std::size_t> at_depth(chains.size(), chains.size());
    for (std::size_t c = 0; c < chains.size(); ++c) {
      if (windings[c] == 0) continue;
      sum += windings[c];
      if (windings[c] != (chains[c].is_ccw ? 1 : -1)) throw Fault(kind, "a chain runs round otherwise" + where);
      if (at_depth[depth_[c]] != chains.size()) throw Fault(kind, "in two chains that are beside each other" + where);
      at_depth[depth_[c]] = c;
    }
    for (std::size_t c = 0; c < chains.size(); ++c)
      if (windings[c] != 0 && chains[c].parent && windings[*chains[c].parent] == 0)
        throw Fault(kind, "in a chain and not in its parent" + where);
    if (sum != (is_inside ? 1 : 0)) throw Fault(kind, (is_inside ? "inside" : "outside") + where);
  }
  [[nodiscard]] static bool is_in_box(const Point& q, const CGAL::Bbox_2& box) {
    return box.xmin() <= q.x && q.x <= box.xmax() && box.ymin() <= q.y && q.y <= box.ymax();
  }
  void check_rounded(const Point& q, std::mt19937& random, Asked_points& asked) const {
    ++asked.asked;
    if (is_near_rounded(q)) {
      ++asked.left_out;
      return;
    }
    const auto inside = is_inside(whole_.seen(whole_.point(q), random));
    if (!inside) return;
    std::vector<int> windings;
    for (const auto& chain : chains_) {
      if (!is_in_box(q, box_of(chain.drawing()))) {  // a chain may be too small to be asked
        windings.push_back(0);
        continue;
      }
      const auto w = ba::Point_location_2(chain).winding_number(q);
      if (w.state != ba::Winding_number::State::DECIDED) return;
      windings.push_back(w.number);
    }
    check_windings(windings, *inside, "rounded", at(q));
  }
  // Points that are farther from the outline than it was moved are on the same side of what is drawn.
  void check_drawn(std::mt19937& random, Asked_points& asked) const {
    const ba::Outline_2::Drawn& drawn = made_.drawn;
    double size = 0;
    for (const Drawing* drawing : operands_)
      for (const auto& curve : drawing->curves())
        for (const Bezier& b : curve.beziers) size = (std::max)(size, b.coordinate_size());
    if (!(drawn.moved <= 8 * made_.moved + 0x1p-36 * size)) throw Fault("drawn", "moved by more than rounding does");
    if (drawn.drawing.curves().size() != drawn.outline.chains.size()) throw Fault("drawn", "not one curve a chain");
    const ba::Bounding_arc_tree_2 tree(drawn.drawing);
    for (int i = 0; i < 12; ++i) {
      const Point q = random_point(random);
      ++asked.asked;
      if (is_near_rounded(q, drawn.moved)) {
        ++asked.left_out;
        continue;
      }
      const auto inside = is_inside(whole_.seen(whole_.point(q), random));
      const auto w = ba::Point_location_2(tree).winding_number(q);
      if (!inside || w.state != ba::Winding_number::State::DECIDED) continue;
      if (w.number != (*inside ? 1 : 0)) throw Fault("drawn", (*inside ? "inside" : "outside") + at(q));
    }
  }
  // From a thousandth of the size down to 64 ulp of it, beside a vertex of the outline or an end of a piece.
  void check_beside_vertex(std::mt19937& random, Asked_points& asked) const {
    const auto& chains = made_.outline.chains;
    Point p;
    const Bezier* of = nullptr;
    if (!chains.empty() && one_in(random, 2)) {
      const auto& part = one_of(random, one_of(random, chains).parts);
      p = part.start;
      of = &source(part);
    } else {
      const Drawing& drawing = *operands_[one_in(random, 2) ? 1 : 0];
      if (drawing.curves().empty()) return;
      of = &one_of(random, one_of(random, drawing.curves()).beziers);
      p = of->control_points().front();
    }
    double size = 0;
    for (const Point& c : of->control_points()) size = (std::max)({size, std::fabs(c.x), std::fabs(c.y)});
    std::uniform_real_distribution<double> unit(0, 1);
    const double r = size * std::exp2(-10 - 36 * unit(random)), angle = 6.283185307179586 * unit(random);
    check_rounded({p.x + r * std::cos(angle), p.y + r * std::sin(angle)}, random, asked);
  }

  void check_exact(const Projective_point& q, std::mt19937& random) const {
    constexpr int RAYS = 8;  // an end that is known to be in a bracket only may be in the way of some
    for (int ray = 0; ray < RAYS; ++ray) {
      const auto seen = whole_.seen(q, random);
      const auto inside = is_inside(seen);
      if (!inside) return;
      if (const auto windings = windings_of_chains(seen)) {
        check_windings(*windings, *inside, "exact", at(whole_.rounded(q)));
        return;
      }
    }
  }
  [[nodiscard]] std::optional<std::vector<int>> windings_of_chains(const std::vector<Seen_piece>& seen) const {
    std::vector<int> windings;
    for (const auto& chain : made_.outline.chains) {
      windings.push_back(0);
      for (const auto& p : chain.parts) {
        const bool reversed = is_reversed(p);
        const auto crossings = seen[whole_.number_of(p.operand, p.curve, p.bezier)].crossings(reversed ? p.to : p.from,
                                                                                              reversed ? p.from : p.to);
        if (!crossings) return std::nullopt;
        windings.back() += reversed ? -*crossings : *crossings;
      }
    }
    return windings;
  }
  // Near any curve, by any distance.
  void check_beside_curve(std::mt19937& random) const {
    if (whole_.size() == 0) return;
    const std::size_t piece = random() % whole_.size();
    std::uniform_real_distribution<double> unit(0, 1);
    double t = unit(random);
    if (one_in(random, 3)) t = std::exp2(-50 * t);
    if (one_in(random, 3)) t = 1 - t;
    const bool is_left = one_in(random, 2);
    if (const auto q = whole_.beside(piece, t, is_left, whole(random, 4, 90), random)) check_exact(*q, random);
  }
  // Inside to the left, outside to the right, nearer than anything else.
  void check_beside_part(std::mt19937& random) const {
    if (made_.outline.chains.empty()) return;
    const auto& part = one_of(random, one_of(random, made_.outline.chains).parts);
    const bool reversed = is_reversed(part);
    const double low = (reversed ? part.to : part.from).upper, high = (reversed ? part.from : part.to).lower,
                 t = low + (high - low) * std::uniform_real_distribution<double>(0.2, 0.8)(random);
    if (!(low < t && t < high)) return;  // shorter than parameters tell
    const std::size_t piece = whole_.number_of(part.operand, part.curve, part.bezier);
    constexpr int NEAR = 110, NEARER = 900;  // curves that are an ulp apart meet at parameters of 1e-46
    for (const bool is_left : {true, false}) {
      const auto q = whole_.beside(piece, t, is_left != reversed, NEAR, random);
      if (!q) return;
      check_exact(*q, random);
      if (is_inside(whole_.seen(*q, random)) == std::optional<bool>(!is_left)) {
        const auto nearer = whole_.beside(piece, t, is_left != reversed, NEARER, random);
        if (is_inside(whole_.seen(*nearer, random)) == std::optional<bool>(!is_left))
          throw Fault("boundary", "a part of it is none" + at(whole_.rounded(*q)));
      }
    }
  }

  std::vector<const Drawing*> operands_;
  Operation how_;
  const Combined& made_;
  Whole_curves whole_;
  std::vector<std::size_t> depth_;
  std::vector<ba::Bounding_arc_tree_2> chains_;
  std::vector<Rounded_piece> pieces_;
  std::vector<std::size_t> chain_of_piece_;
};

/// Combines two drawings, and checks all that holds of what that makes.
/// \throws Told_fault
template <class Tree>
Combined checked(const Drawing& a, const Drawing& b, const Operation& how, std::mt19937& random, Asked_points& asked) {
  const Combined made = combined<Tree>(a, b, how);
  told(words_of(how), a, b, [&] { Checked_outline(a, b, how, made).check(random, asked); });
  return made;
}

}  // namespace bounding_arcs_test

#endif
