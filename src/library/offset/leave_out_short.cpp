// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Short pieces are left out: a neighbour is led on to where they began or ended.
//
//         __B_______        How far points of the new arc are from B. They are within 8/5 of the largest distance w of
//     ___s                  its ends and middle from the circle of B, as in put_together.cpp. Their feet there are on
//   A                       B, or before it: no farther than s is long, and w.  So |s| + 2 (8/5) w bounds all.
//                           That is added to what B was moved by when it was led on before.

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include "../arc/arc_crossings.h"
#include "Arc_boxes.h"
#include "Raw_offset.h"
#include "offset_chains.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs {
namespace {

constexpr double SHORT_OF_EPS = 0x1p-4;

class Short_pieces {
 public:
  Short_pieces(Offset& offset, double eps, double most, double room)
      : offset_(offset), eps_(eps), most_(most), room_(room) {}

  double leave_out() {
    double moved = 0;
    for (Offset::Chain& chain : offset_.chains) {
      const double length = least_length(chain);
      if (length == 0) continue;
      if (links_.empty()) link();
      moved = (std::max)(moved, leave_out_of(chain, length));
    }
    return moved;
  }

 private:
  struct Link {
    Arc_2 arc;
    std::uint32_t before, behind;  // NONE at ends of open chains
    double moved;
    bool is_left_out;
  };
  struct Led_on {
    std::uint32_t link;
    Arc_2 arc;
    double moved;
  };
  static constexpr std::uint32_t NONE = static_cast<std::uint32_t>(-1);

  // 0 where no piece is shorter. What runs round a thin region is not moved by so much of eps.
  [[nodiscard]] double least_length(const Offset::Chain& chain) const {
    const double length = SHORT_OF_EPS * eps_;
    const auto is_short = [&](const Offset::Piece& p) {
      const Xy<double> chord = p.arc.to - p.arc.from;
      return dot(chord, chord) < length * length;
    };
    if (std::none_of(chain.pieces.begin(), chain.pieces.end(), is_short)) return 0;
    if (!chain.is_closed) return length;
    const internal::Chain_size size = internal::size_of(chain.pieces);
    return SHORT_OF_EPS * (std::min)(eps_, std::fabs(size.area) / size.length);
  }

  void link() {
    for (const Offset::Chain& chain : offset_.chains) {
      const auto begin = static_cast<std::uint32_t>(links_.size());
      begins_.push_back(begin);
      links_.resize(begin + chain.pieces.size());
      link(chain, begin);
    }
    begins_.push_back(static_cast<std::uint32_t>(links_.size()));
    blocks_ = internal::Arc_blocks(
        begins_, [&](std::uint32_t i) -> const Arc_2& { return links_[i].arc; }, [](std::uint32_t) { return 0.0; },
        most_);
    blocks_.drop_boxes_of_arcs();
  }

  void link(const Offset::Chain& chain, std::uint32_t begin) {
    const auto end = begin + static_cast<std::uint32_t>(chain.pieces.size());
    for (std::uint32_t i = begin; i < end; ++i) links_[i] = {chain.pieces[i - begin].arc, i - 1, i + 1, 0, false};
    links_[begin].before = chain.is_closed ? end - 1 : NONE;
    links_[end - 1].behind = chain.is_closed ? begin : NONE;
  }

  double leave_out_of(Offset::Chain& chain, double least) {
    const std::uint32_t begin = begins_[static_cast<std::size_t>(&chain - offset_.chains.data())];
    std::vector<Offset::Piece>& pieces = chain.pieces;
    std::size_t count = pieces.size();
    double moved = 0;
    for (std::uint32_t i = 0; i < pieces.size() && count > (chain.is_closed ? 2U : 1U); ++i) {
      if (length(links_[begin + i].arc) >= least) continue;
      const std::optional<Led_on> on = best(begin + i, pieces, begin);
      if (!on) continue;
      moved = (std::max)(moved, on->moved);
      replace(begin + i, *on);
      --count;
    }
    if (count == pieces.size()) return 0;
    std::vector<Offset::Piece> left;
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      if (links_[begin + i].is_left_out) continue;
      left.push_back(pieces[i]);
      left.back().arc = links_[begin + i].arc;
    }
    if (chain.is_closed) {
      const double area = internal::size_of(left).area;
      if ((area > 0) != chain.is_ccw) {
        link(chain, begin);  // it stays as it is
        return 0;
      }
      chain.area = area;
    }
    pieces = std::move(left);
    return moved;
  }

  // The neighbour that is moved less, led on.
  [[nodiscard]] std::optional<Led_on> best(std::uint32_t i, const std::vector<Offset::Piece>& pieces,
                                           std::uint32_t begin) const {
    std::optional<Led_on> result;
    const Link& s = links_[i];
    if (is_tip(s)) return result;
    for (const std::uint32_t k : {s.before, s.behind}) {
      if (k == NONE || (pieces[i - begin].is_round && !pieces[k - begin].is_round)) continue;
      const bool is_before = k == s.before;
      const Arc_2 whole = is_before ? reversed(links_[k].arc) : links_[k].arc;
      const Arc_2 arc = internal::from_another_start(whole, is_before ? s.arc.to : s.arc.from);
      const double moved = links_[k].moved + length(s.arc) + way_from_circle(arc, whole);
      if (!(moved <= most_) || !(std::fabs(arc.bulge) <= 1) || arc.from == arc.to) continue;
      const Led_on on{k, is_before ? reversed(arc) : arc, moved};
      if ((!result || moved < result->moved) && crosses_nothing(i, on)) result = on;
    }
    return result;
  }
  // Whether neighbours turn back: blunt_cusps() put the piece there, as without it rounding tells whether they cross.
  [[nodiscard]] bool is_tip(const Link& s) const {
    constexpr double TURNS_BACK = 0x1p-20;  // as there
    if (s.before == NONE || s.behind == NONE) return false;
    const Xy<double> coming = tangent(links_[s.before].arc, 1), going = tangent(links_[s.behind].arc, 0);
    return dot(coming, going) < 0 && std::fabs(cross(coming, going)) <= TURNS_BACK;
  }
  // Beyond the length of what is left out; see above.
  [[nodiscard]] double way_from_circle(const Arc_2& arc, const Arc_2& whole) const {
    constexpr double OF_LARGEST = 2 * 1.6;
    double most = 0;
    for (const Xy<double>& q : {arc.from, moebius_point(arc, 0.5)}) {
      const Arc_view<double> v = view(q, whole);
      most = (std::max)(most, std::fabs(distance_to_circle(v, v.apart, whole.bulge)));
    }
    return OF_LARGEST * (most + room_);
  }
  // Whether the arc meets others only where it follows them.
  [[nodiscard]] bool crosses_nothing(std::uint32_t i, const Led_on& on) const {
    const bool is_before = on.link == links_[i].before;
    const std::uint32_t before = is_before ? links_[on.link].before : links_[i].before,
                        behind = is_before ? links_[i].behind : links_[on.link].behind;
    const CGAL::Bbox_2 b = internal::box_about(on.arc);
    const auto is_apart = [&](std::uint32_t j) {
      if (j == i || j == on.link || links_[j].is_left_out) return true;
      const Arc_2& other = links_[j].arc;
      if (!CGAL::do_overlap(b, internal::box_about(other))) return true;
      if (j == before && meet_again(other, on.arc, room_)) return false;
      if (j == behind && meet_again(on.arc, other, room_)) return false;
      if (j == before || j == behind) return true;
      const Arc_crossings c = crossings(on.arc, other, room_);
      return c.count == 0 && !c.is_doubtful;
    };
    const auto is_near = [&](const Box_tree::Node& n, std::size_t k) {
      return n.x_low[k] <= b.xmax() && b.xmin() <= n.x_high[k] && n.y_low[k] <= b.ymax() && b.ymin() <= n.y_high[k];
    };
    return for_each_item(blocks_.tree(), is_near, [&](const Box_tree::Node& n, std::size_t k) {
      const internal::Arc_block& block = blocks_.block(n.child[k]);
      for (std::uint32_t j = block.begin; j < block.end; ++j)
        if (!is_apart(j)) return false;
      return true;
    });
  }

  void replace(std::uint32_t i, const Led_on& on) {
    Link& s = links_[i];
    s.is_left_out = true;
    if (s.before != NONE) links_[s.before].behind = s.behind;
    if (s.behind != NONE) links_[s.behind].before = s.before;
    links_[on.link].arc = on.arc;
    links_[on.link].moved = on.moved;
  }

  Offset& offset_;
  double eps_, most_, room_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> begins_;  // of each chain, and their end
  internal::Arc_blocks blocks_;        // with boxes that hold arcs when they are moved, too
};

}  // namespace

double leave_out_short(Offset& offset, double eps, double most, double room) {
  return Short_pieces(offset, eps, most, room).leave_out();
}

}  // namespace CGAL::Bounding_arcs
