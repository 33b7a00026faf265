// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a hierarchy is made: segments of each Bezier piece, samples at their ends, fat arcs, boxes.

#include "Segment_hierarchy.h"
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/spiral/spiral_parameters.h>
#include "../curve/exact_bezier.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

// How far a curve may be from the one with rounded numbers, 0 where they were doubles. Points of a rational curve with
// weights within relative errors of u are combinations of the same control points with coefficients within 2 u; their
// sum of parts moves the point by 4 u of the coordinates' size at most.
static double rounding_error(const Bezier_evaluator& curve, const Bezier_curve_2<Exact_rational>& exact,
                             const Bezier_curve_2<double>& rounded) {
  bool is_same = true;
  for (std::size_t i = 0; i < exact.control_points().size(); ++i) {
    const auto& p = exact.control_points()[i];
    const auto& q = rounded.control_points()[i];
    is_same = is_same && p.x == Exact_rational(q.x) && p.y == Exact_rational(q.y);
  }
  for (std::size_t i = 0; i < exact.weights().size(); ++i)
    is_same = is_same && exact.weights()[i] == Exact_rational(rounded.weights()[i]);
  if (is_same) return 0;
  constexpr double OF_COORDINATES = 1.5, OF_WEIGHTS = 6, DENORMAL = 0x1p-1073;
  return (OF_COORDINATES + (curve.is_rational() ? OF_WEIGHTS : 0)) * HALF_ULP * curve.coordinate_size() + DENORMAL;
}

Segment_hierarchy::Segment_hierarchy(const Drawing_2<Exact_rational>& drawing, Decisions decisions)
    : drawing_(std::make_shared<const Drawing_2<double>>(drawing.over<double>())), decisions_(decisions) {
  is_rounded_ = !drawing.curves().empty();
  build(&drawing, nullptr);
}

void Segment_hierarchy::build(const Drawing_2<Exact_rational>* exact, const Segment_hierarchy* cut) {
  std::size_t count = 0;
  for (const auto& curve : drawing_->curves()) count += curve.beziers.size();
  constexpr std::size_t USUAL = 4, MOST_OF_ONE = 12;  // segments of a cubic piece
  evaluators_.reserve(count);
  first_bezier_.reserve(drawing_->curves().size());
  segments_.reserve((std::max)(USUAL * count, MOST_OF_ONE));
  for (std::size_t i = 0; i < drawing_->curves().size(); ++i) {
    const auto& curve = drawing_->curves()[i];
    first_bezier_.push_back(static_cast<std::uint32_t>(evaluators_.size()));
    for (std::size_t j = 0; j < curve.beziers.size(); ++j) {
      const auto bezier = static_cast<std::uint32_t>(evaluators_.size());
      evaluators_.emplace_back(curve.beziers[j]);
      if (exact != nullptr) {
        exact_.push_back(exact->curves()[i].beziers[j]);
        roundings_.push_back(rounding_error(evaluators_.back(), exact_.back(), curve.beziers[j]));
      }
      add_segments(curve.beziers[j], cut == nullptr ? spiral_parameters(curve.beziers[j]) : cut->cuts(bezier), bezier,
                   internal::bezier_place(curve, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j)));
    }
  }
}

Segment_hierarchy Segment_hierarchy::parted(const std::vector<Segment_part>& parts) const {
  Segment_hierarchy result(*this);
  result.segments_.clear();
  result.boxes_ = std::make_shared<internal::Made_once<Box_tree>>();
  for (const Segment_part& part : parts) {
    const Segment& whole = segments_[part.piece.segment];
    Segment s = whole;
    s.first = part.piece.first;
    s.last = part.piece.last;
    s.error = part.error;
    if (s.first.t != whole.first.t) s.place.first = Cut_reason::JOINT;
    if (s.last.t != whole.last.t) s.place.last = Cut_reason::JOINT;
    if (part.moved) result.move(s, *part.moved);
    s.set_region(fat_of(s));
    result.segments_.push_back(s);
  }
  return result;
}

Segment_hierarchy::Segment_hierarchy(const std::vector<std::shared_ptr<const Segment_hierarchy>>& members)
    : is_forest_(true) {
  std::size_t beziers = 0, segments = 0;
  for (const auto& of : members) {
    beziers += of->number_of_beziers();
    segments += of->number_of_segments();
  }
  members_.reserve(members.size());
  member_of_bezier_.reserve(beziers);
  member_of_segment_.reserve(segments);
  Drawing_2<double> drawing;
  for (const auto& of : members) {
    const auto number = static_cast<std::uint32_t>(members_.size()),
               first_bezier = static_cast<std::uint32_t>(member_of_bezier_.size());
    members_.push_back({of, static_cast<std::uint32_t>(drawing.curves().size()), first_bezier,
                        static_cast<std::uint32_t>(member_of_segment_.size())});
    member_of_bezier_.resize(member_of_bezier_.size() + of->number_of_beziers(), number);
    member_of_segment_.resize(member_of_segment_.size() + of->number_of_segments(), number);
    for (const std::uint32_t first : of->first_bezier_) first_bezier_.push_back(first_bezier + first);
    for (const std::uint32_t tip : of->hidden_tips_) hidden_tips_.push_back(first_bezier + tip);
    drawing.add(of->drawing());
    is_rounded_ = is_rounded_ || of->is_rounded();
    if (of->decisions() == Decisions::DOUBLE) decisions_ = Decisions::DOUBLE;
  }
  drawing_ = std::make_shared<const Drawing_2<double>>(std::move(drawing));
}

Segment_hierarchy Segment_hierarchy::of_pieces(const std::vector<std::uint32_t>& kept) const {
  Segment_hierarchy result;
  result.decisions_ = decisions_;
  result.is_rounded_ = is_rounded_;
  result.evaluators_.reserve(kept.size());
  result.segments_.reserve(segments_.size());
  Drawing_2<double> drawing;
  for (std::size_t begin = 0, end = 0; begin < kept.size(); begin = end) {
    const std::size_t curve = curve_of_bezier(kept[begin]);
    while (end < kept.size() && curve_of_bezier(kept[end]) == curve) ++end;
    std::vector<Bezier_curve_2<double>> chain;
    chain.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i) chain.push_back(bezier(kept[i]));
    drawing.add(std::move(chain), drawing_->curves()[curve].name);
    result.first_bezier_.push_back(static_cast<std::uint32_t>(begin));
    for (std::size_t i = begin; i < end; ++i)
      result.add_copies(
          *this, kept[i],
          internal::bezier_place(drawing.curves().back(), static_cast<std::uint32_t>(drawing.curves().size() - 1),
                                 static_cast<std::uint32_t>(i - begin)));
  }
  result.drawing_ = std::make_shared<const Drawing_2<double>>(std::move(drawing));
  return result;
}

// Appends the segments that another hierarchy has of a Bezier piece.
void Segment_hierarchy::add_copies(const Segment_hierarchy& of, std::uint32_t number, const Segment_place& place) {
  const auto bezier = static_cast<std::uint32_t>(evaluators_.size());
  evaluators_.push_back(of.evaluators_[number]);
  if (is_rounded_) {
    exact_.push_back(of.exact_[number]);
    roundings_.push_back(of.roundings_[number]);
  }
  const std::size_t first = segments_.size();
  for (auto s = of.first_segment(number); s != of.segments_.end() && s->bezier == number; ++s) {
    Segment copy = *s;
    copy.place.curve = place.curve;
    copy.place.bezier = place.bezier;
    copy.bezier = bezier;
    segments_.push_back(copy);
  }
  segments_[first].place.first = place.first;
  segments_.back().place.last = place.last;
  if (std::binary_search(of.hidden_tips_.begin(), of.hidden_tips_.end(), number)) hidden_tips_.push_back(bezier);
  if (const auto coarse = of.coarse_cuts_.find(number); coarse != of.coarse_cuts_.end())
    coarse_cuts_.emplace(bezier, coarse->second);
}

std::vector<Segment_hierarchy::Segment>::const_iterator Segment_hierarchy::first_segment(std::uint32_t bezier) const {
  return std::partition_point(segments_.begin(), segments_.end(), [&](const Segment& s) { return s.bezier < bezier; });
}

// Puts `others` in the place of first, ..., last - 1. \pre there is room for all
template <class T>
static void splice(std::vector<T>& all, std::size_t first, std::size_t last, std::vector<T>& others) {
  const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t count = (std::min)(last - first, others.size());
  const auto rest = others.begin() + static_cast<std::ptrdiff_t>(count);
  std::move(others.begin(), rest, at(first));
  all.erase(at(first + count), at(last));
  all.insert(at(first + count), std::make_move_iterator(rest), std::make_move_iterator(others.end()));
}

void Segment_hierarchy::replace(std::size_t first, std::size_t last, Drawing_2<double> curves) {
  Segment_hierarchy made(std::make_shared<const Drawing_2<double>>(curves), decisions_);
  const auto first_bezier_at = [this](std::size_t curve) {
    return curve < first_bezier_.size() ? first_bezier_[curve] : static_cast<std::uint32_t>(evaluators_.size());
  };
  const std::uint32_t begin = first_bezier_at(first), end = first_bezier_at(last);
  const auto segment_at = [this](std::uint32_t bezier) {
    return static_cast<std::size_t>(first_segment(bezier) - segments_.begin());
  };
  const std::size_t from = segment_at(begin), to = segment_at(end), made_segments = made.segments_.size();
  const auto curve_change = static_cast<std::uint32_t>(curves.curves().size() - (last - first)),  // modulo 2^32
      bezier_change = static_cast<std::uint32_t>(made.evaluators_.size()) - (end - begin);
  const bool is_refit = made_segments == to - from;
  constexpr int OWN = 2;  // pointers to it
  auto drawing = own_drawing_.use_count() == OWN ? own_drawing_ : std::make_shared<Drawing_2<double>>(*drawing_);
  auto boxes = std::make_shared<internal::Made_once<Box_tree>>();
  if (is_refit && boxes_.use_count() == 1) boxes = boxes_;
  else if (is_refit && has_boxes()) (void)(*boxes)([&] { return *boxes_->made(); });
  if (Box_tree* made_boxes = boxes->made()) made_boxes->find_parents();
  std::vector<std::uint32_t> tips;
  for (const std::uint32_t b : hidden_tips_)
    if (b < begin) tips.push_back(b);
  for (const std::uint32_t b : made.hidden_tips_) tips.push_back(b + begin);
  for (const std::uint32_t b : hidden_tips_)
    if (b >= end) tips.push_back(b + bezier_change);
  std::map<std::uint32_t, Spiral_parameters> coarse;
  for (const auto& [number, cuts] : coarse_cuts_)
    if (number < begin || number >= end) coarse.emplace(number < begin ? number : number + bezier_change, cuts);
  for (const auto& [number, cuts] : made.coarse_cuts_) coarse.emplace(number + begin, cuts);
  evaluators_.reserve(evaluators_.size() + made.evaluators_.size());
  first_bezier_.reserve(first_bezier_.size() + made.first_bezier_.size());
  segments_.reserve(segments_.size() + made_segments);
  drawing->replace(first, last, std::move(curves));  // which throws before it changes anything
  for (std::uint32_t& b : made.first_bezier_) b += begin;
  for (Segment& s : made.segments_) {
    s.place.curve += static_cast<std::uint32_t>(first);
    s.bezier += begin;
  }
  const std::size_t made_curves = made.first_bezier_.size();
  splice(first_bezier_, first, last, made.first_bezier_);
  splice(evaluators_, begin, end, made.evaluators_);
  splice(segments_, from, to, made.segments_);
  if (bezier_change != 0)
    for (std::size_t i = first + made_curves; i < first_bezier_.size(); ++i) first_bezier_[i] += bezier_change;
  if (!is_refit || bezier_change != 0 || curve_change != 0)
    for (std::size_t i = from + made_segments; i < segments_.size(); ++i) {
      segments_[i].place.curve += curve_change;
      segments_[i].bezier += bezier_change;
    }
  hidden_tips_ = std::move(tips);
  coarse_cuts_ = std::move(coarse);
  if (Box_tree* made_boxes = boxes->made()) made_boxes->refit(from, to, [&](std::size_t i) { return box_at(i); });
  boxes_ = std::move(boxes);
  drawing_ = own_drawing_ = std::move(drawing);
}

// Directions that the new curve does not tell, at a cusp, are those that were.
void Segment_hierarchy::move(Segment& s, const Bezier_curve_2<double>& curve) {
  s.bezier = static_cast<std::uint32_t>(evaluators_.size());
  evaluators_.emplace_back(curve);
  if (is_rounded()) roundings_.push_back(0);
  for (Spiral_sample* end : {&s.first, &s.last}) {
    const Spiral_sample before = *end;
    *end = sample_of(s.bezier, end->t, evaluators_.back()(end->t));
    constexpr double GOOD = 0x1p-24;
    if (end->tangent_error > GOOD) end->tangent = before.tangent, end->tangent_error = before.tangent_error;
  }
  if (s.is_straight) straighten(s);
}

void Segment_hierarchy::add_segments(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts,
                                     std::uint32_t bezier, const Segment_place& place) {
  const std::size_t first = segments_.size();
  constexpr double OF_ENDS_AND_CUTS = 4 * HALF_ULP;  // of points and of parameters
  const double error =
      evaluators_[bezier].point_error() + OF_ENDS_AND_CUTS * evaluators_[bezier].coordinate_size() + rounding(bezier);
  Segment segment{{}, {}, error, 0, 0, place, bezier, cuts.is_straight};
  double t0 = 0;
  for (std::size_t i = 0; i <= cuts.breaks.size(); ++i) {
    const bool is_last = i == cuts.breaks.size();
    const double t1 = is_last ? 1 : cuts.breaks[i];
    segment.place.last = is_last ? place.last : cuts.reasons[i];
    segment.first = i == 0 ? sample_of(bezier, t0, evaluators_[bezier](t0)) : segment.last;
    segment.last = sample_of(bezier, t1, evaluators_[bezier](t1));
    segments_.push_back(segment);
    segment.place.first = segment.place.last;
    t0 = t1;
  }
  mend_ends(curve, cuts, first);
  const bool has_hidden_tip = cuts.has_hidden_tip || may_turn_beside_end(segments_[first], true) ||
                              may_turn_beside_end(segments_.back(), false);
  if (has_hidden_tip) hidden_tips_.push_back(bezier);
  for (std::size_t i = first; i < segments_.size(); ++i) {
    if (has_hidden_tip)
      segments_[i].first.tangent_error = segments_[i].last.tangent_error = std::numeric_limits<double>::infinity();
    segments_[i].set_region(fat_of(segments_[i]));
  }
}

// Whether the curve may turn next to an end, nearer than cuts are told. It leaves the end towards the next control
// point that is another one, which is the exact direction there: the one that the segment claims is another one, or
// doubles do not tell it, as the control point is some ulp from the end.
bool Segment_hierarchy::may_turn_beside_end(const Segment& s, bool at_start) const {
  const Bezier_evaluator& curve = evaluators_[s.bezier];
  const auto& p = curve.curve().control_points();
  if (p.size() < 3) return false;
  const std::size_t n = p.size() - 1;
  std::size_t next = 1;
  while (next < n && p[at_start ? next : n - next] == p[at_start ? 0 : n]) ++next;
  const Xy<double> way = at_start ? p[next] - p[0] : p[n] - p[n - next];
  const double length = stable_norm(way);
  if (length == 0) return false;
  constexpr double CERTAIN = 4, SHORT = 0x1p-40;  // times the error, and the size; that is for extreme weights alone
  const double t = at_start ? 0 : 1;
  const internal::Curve_jet jet = curve(t);
  if (length <= SHORT * curve.coordinate_size() &&
      !(euclidean_norm(jet.first) >= CERTAIN * curve.errors_at(t, jet).first))
    return true;
  const Spiral_sample& end = at_start ? s.first : s.last;
  const double room = end.tangent_error + 8 * HALF_ULP + 4 * rounding(s.bezier) / length;
  return room < 1 && !(dot(way, end.tangent) > 0 && std::fabs(cross(way, end.tangent)) <= room * length);
}

// The direction of a straight segment is that of its chord, as its derivatives may vanish where it turns back.
void Segment_hierarchy::straighten(Segment& s) {
  const Xy<double> chord = s.last.point - s.first.point;
  const double length = stable_norm(chord);
  for (Spiral_sample* end : {&s.first, &s.last}) {
    if (length > 0) end->tangent = {chord.x / length, chord.y / length};
    end->tangent_error = 2 * s.error / length + 4 * HALF_ULP;
    end->most_curvature = end->least_curvature = 0;
  }
}

// Next to a cusp doubles do not tell the direction of C', the accurate shape of the segment does.  How far a rational
// curve runs within a cut's width the segment tells, too.
void Segment_hierarchy::mend_ends(const Bezier_curve_2<double>& curve, const Spiral_parameters& cuts,
                                  std::size_t first) {
  constexpr double GOOD = 0x1p-24;  // directions as good as this need no mending
  bool is_good = !curve.is_rational();
  for (std::size_t i = first; i < segments_.size(); ++i) {
    Segment& s = segments_[i];
    if (!s.is_straight) {
      is_good = is_good && s.first.tangent_error <= GOOD && s.last.tangent_error <= GOOD;
      continue;
    }
    straighten(s);
  }
  if (is_good) return;
  std::vector<Bezier_spiral_2<double>> spirals;
  internal::add_spiral_segments(curve, cuts, segments_[first].place, spirals);
  // where weights differ so much that a curve turns within the width of a cut, that is a segment by itself
  constexpr double COARSE = 0x1p-44;
  std::vector<std::size_t> coarse;
  std::vector<double> coarse_errors;
  const double curve_size = evaluators_[segments_[first].bezier].coordinate_size();
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    Segment& s = segments_[first + i];
    if (spirals[i].cut_error() > COARSE * curve_size) {
      coarse.push_back(first + i);
      coarse_errors.push_back(spirals[i].cut_error());
      continue;
    }
    s.error += spirals[i].cut_error();
    if (s.is_straight || (s.first.tangent_error <= GOOD && s.last.tangent_error <= GOOD)) continue;
    const Chord_shape_2<double> shape =
        spirals[i].accurate_shape(spirals[i].first(), spirals[i].last(), {false, false});
    const auto mend = [&](Spiral_sample& end, const Xy<double>& tangent) {
      const double length = stable_norm(tangent);
      if (end.tangent_error <= GOOD || !(length > 0)) return;
      end.tangent = {tangent.x / length, tangent.y / length};
      // of rounded control points the direction at a cusp may be another one
      if (rounding(s.bezier) == 0) end.tangent_error = 8 * HALF_ULP;
    };
    mend(s.first, shape.tangent0);
    mend(s.last, shape.tangent1);
  }
  if (!coarse.empty()) coarse_cuts_.emplace(std::uint32_t(segments_[first].bezier), cuts);
  for (std::size_t i = coarse.size(); i-- > 0;) separate_cuts(coarse[i], coarse_errors[i]);
}

// What cuts may have missed is beside an end of the segment: of these two slivers only a box is known, and between them
// the segment is a spiral whose error has nothing of theirs.
void Segment_hierarchy::separate_cuts(std::size_t segment, double cut_error) {
  constexpr double WIDTH = 2 * CUT_WIDTH;  // rounding of cuts and of these ends has room
  Segment whole = segments_[segment];
  if (whole.is_straight && whole.first.point == whole.last.point) {
    segments_[segment].error += cut_error;
    return;
  }
  const double t0 = whole.first.t + WIDTH, t1 = whole.last.t - WIDTH;
  for (Spiral_sample* end : {&whole.first, &whole.last}) {
    end->tangent_error = end->most_curvature = std::numeric_limits<double>::infinity();
    end->least_curvature = 0;
  }
  Segment before = whole, inside = whole, behind = whole;
  const Bezier_evaluator& curve = evaluators_[whole.bezier];
  // at most the length of a sliver, by the speed at its end
  const auto way_at = [&](double t) {
    const internal::Curve_jet jet = curve(t);
    const double speed = euclidean_norm(jet.first) + curve.errors_at(t, jet).first + WIDTH * curve.second_bound();
    return (std::min)(cut_error, WIDTH * speed * (1 + 0x1p-40));
  };
  before.error = whole.error + way_at(whole.first.t);
  behind.error = whole.error + way_at(whole.last.t);
  if (!(t0 < t1)) {
    before.error = whole.error + cut_error;
    segments_[segment] = before;
    return;
  }
  inside.first = sample_of(whole.bezier, t0, curve(t0));
  inside.last = sample_of(whole.bezier, t1, curve(t1));
  if (whole.is_straight) straighten(inside);
  before.last = inside.first;
  behind.first = inside.last;
  before.place.last = inside.place.first;
  behind.place.first = inside.place.last;
  segments_[segment] = before;
  const auto next = segments_.begin() + static_cast<std::ptrdiff_t>(segment) + 1;
  segments_.insert(next, {inside, behind});
}

bool Segment_hierarchy::is_point(std::uint32_t bezier) const {
  const auto are_equal = [](const auto& p) {
    return std::all_of(p.begin(), p.end(), [&](const auto& q) { return q == p.front(); });
  };
  if (!are_equal(this->bezier(bezier).control_points())) return false;
  return rounding(bezier) == 0 || are_equal(exact_bezier(bezier).control_points());
}

Spiral_parameters Segment_hierarchy::cuts(std::uint32_t bezier) const {
  if (const auto coarse = coarse_cuts_.find(bezier); coarse != coarse_cuts_.end()) return coarse->second;
  Spiral_parameters cuts;
  auto s = first_segment(bezier);
  cuts.is_straight = s->is_straight;
  cuts.has_hidden_tip = std::binary_search(hidden_tips_.begin(), hidden_tips_.end(), bezier);
  for (; s + 1 != segments_.end() && (s + 1)->bezier == bezier; ++s) {
    cuts.breaks.push_back(s->last.t);
    cuts.reasons.push_back(s->place.last);
  }
  return cuts;
}

Segment_hierarchy::Exact_bezier Segment_hierarchy::exact_bezier(std::uint32_t bezier) const {
  if (is_forest()) {
    const Member& member = members_[member_of_bezier_[bezier]];
    return member.of->exact_bezier(bezier - member.first_bezier);
  }
  if (is_rounded_) return exact_[bezier];
  return Bounding_arcs::exact_bezier(this->bezier(bezier));
}

}  // namespace CGAL::Bounding_arcs
