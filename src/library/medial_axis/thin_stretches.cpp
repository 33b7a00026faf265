// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of medial_axis/thin_stretches.h.

#include <CGAL/Bounding_arcs_2/medial_axis/internal/axis_units.h>
#include <CGAL/Bounding_arcs_2/medial_axis/thin_stretches.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Bounding_arcs {

namespace {

constexpr double HALF_TURN = 3.14159265358979323846;

[[nodiscard]] Medial_sample reversed(Medial_sample s) {
  std::swap(s.left, s.right);
  return s;
}
[[nodiscard]] Curve_place between(const Curve_place& p, const Curve_place& q, double share) {
  if (p.curve != q.curve || p.bezier != q.bezier) return share < 0.5 ? p : q;
  return {p.curve, p.bezier, p.t + share * (q.t - p.t)};
}
[[nodiscard]] Medial_sample between(const Medial_sample& s, const Medial_sample& t, double share) {
  return {s.center + share * (t.center - s.center), s.radius + share * (t.radius - s.radius),
          between(s.left, t.left, share), between(s.right, t.right, share)};
}

// The steps from sample to sample of an axis, between discs: its vertices, then the samples between them.
class Axis_steps {
 public:
  explicit Axis_steps(const Medial_axis_2& axis) : discs_(axis.vertices.size()) {
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const Medial_vertex& v = axis.vertices[i];
      discs_[i].sample = {v.center, v.radius, {}, {}};
      if (!v.touches.empty()) discs_[i].sample.left = v.touches.front(), discs_[i].sample.right = v.touches.back();
    }
    for (const Medial_edge& e : axis.edges)
      for (std::size_t i = 0, from = e.from; i + 1 < e.samples.size(); ++i) {
        const std::size_t to = i + 2 < e.samples.size() ? discs_.size() : e.to;
        if (to == discs_.size()) discs_.emplace_back();
        discs_[from].sample = e.samples[i], discs_[to].sample = e.samples[i + 1];
        for (const std::size_t disc : {from, to}) discs_[disc].steps.push_back(steps_.size());
        steps_.push_back({from, to, &e.samples[i]});
        from = to;
      }
  }

  // Takes away what runs into corners: steps from ends along which the radius rises by that share of the way or more.
  void take_corners(double rise, double room) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < discs_.size(); ++i)
      if (discs_[i].steps.size() == 1) ends.push_back(i);
    while (!ends.empty()) {
      Disc& end = discs_[ends.back()];
      ends.pop_back();
      if (end.steps.size() != 1) continue;  // its step is gone
      const std::size_t step = end.steps.front();
      const std::size_t beyond = steps_[step].from == index(end) ? steps_[step].to : steps_[step].from;
      Disc& other = discs_[beyond];
      const double way = euclidean_norm(other.sample.center - end.sample.center);
      if (other.sample.radius - end.sample.radius + room < rise * way) continue;
      end.steps.clear();
      end.is_gone = true;
      other.steps.erase(std::find(other.steps.begin(), other.steps.end(), step));
      if (other.steps.size() == 1) ends.push_back(beyond);
      steps_[step].is_gone = true;
    }
  }

  // The ways along discs with a smaller radius; they end in places of the radius `most`.
  [[nodiscard]] std::vector<Thin_stretch> thinner_than(double radius, double most) {
    radius_ = radius, most_ = most;
    std::vector<Thin_stretch> result;
    for (const Disc& d : discs_)
      if (d.steps.empty() && !d.is_gone && d.sample.radius < radius) result.push_back({{d.sample}, 0, 0});
    for (std::size_t i = 0; i < steps_.size(); ++i)
      for (const bool is_forward : {true, false})
        if (is_thin(i) && !goes_on(i, !is_forward)) result.push_back(way(i, is_forward));
    for (std::size_t i = 0; i < steps_.size(); ++i)  // rings are left
      if (is_thin(i)) result.push_back(way(i, true));
    return result;
  }

 private:
  struct Disc {
    Medial_sample sample;
    std::vector<std::size_t> steps;
    bool is_gone = false;
  };
  struct Step {
    std::size_t from, to;
    const Medial_sample* first;  // the next one is the last
    bool is_gone = false;        // or part of a stretch that was found
  };

  [[nodiscard]] std::size_t index(const Disc& d) const { return static_cast<std::size_t>(&d - discs_.data()); }
  [[nodiscard]] bool is_thin(std::size_t step) const {
    const Step& s = steps_[step];
    return !s.is_gone && (s.first[0].radius < radius_ || s.first[1].radius < radius_);
  }
  [[nodiscard]] std::size_t end_of(std::size_t step, bool is_forward) const {
    return is_forward ? steps_[step].to : steps_[step].from;
  }
  // Whether a way goes on at an end of a step.
  [[nodiscard]] bool goes_on(std::size_t step, bool is_forward) const {
    const Disc& d = discs_[end_of(step, is_forward)];
    return d.steps.size() == 2 && d.sample.radius < radius_;
  }
  // The disc at an end of a step, or where it has the largest radius before that.
  [[nodiscard]] Medial_sample sample_at(std::size_t step, bool is_last, bool is_forward) const {
    const Medial_sample *s = steps_[step].first, &own = s[is_last ? 1 : 0], &other = s[is_last ? 0 : 1];
    const double share =
        own.radius < radius_ ? 1 : (std::min)((most_ - other.radius) / (own.radius - other.radius), 1.0);
    const Medial_sample found = share < 1 ? between(other, own, share) : own;
    return is_forward ? found : reversed(found);
  }
  [[nodiscard]] Thin_stretch way(std::size_t step, bool is_forward) {
    Thin_stretch result;
    result.samples.push_back(sample_at(step, !is_forward, is_forward));
    while (true) {
      result.samples.push_back(sample_at(step, is_forward, is_forward));
      steps_[step].is_gone = true;
      if (!goes_on(step, is_forward)) break;
      const std::size_t disc = end_of(step, is_forward);
      const std::vector<std::size_t>& both = discs_[disc].steps;
      const std::size_t next = both[0] == step ? both[1] : both[0];
      if (steps_[next].is_gone) break;
      step = next, is_forward = steps_[next].from == disc;
    }
    for (std::size_t i = 1; i < result.samples.size(); ++i) {
      result.length += euclidean_norm(result.samples[i].center - result.samples[i - 1].center);
      if (result.samples[i].radius < result.disc().radius) result.least = i;
    }
    return result;
  }

  std::vector<Disc> discs_;
  std::vector<Step> steps_;
  double radius_ = 0, most_ = 0;
};

}  // namespace

std::vector<Thin_stretch> thin_stretches(const Medial_axis_2& axis, double limit, double corner) {
  if (!(limit > 0)) throw std::invalid_argument(expected("limit", "a length above 0", limit));
  if (!(corner > 0 && corner <= HALF_TURN))
    throw std::invalid_argument(expected("corner", "an angle above 0 and at most pi", corner));
  constexpr double SAME = 0x1p-20;  // radians: corners of this angle are told by rounded discs
  constexpr double ROOM = 0x1p-40;  // of the size: what discs are checked within
  const Unit unit = internal::unit_of(axis);
  const Medial_axis_2 scaled = internal::in(unit, axis);
  double size = 0;
  for (const Medial_vertex& v : scaled.vertices)
    size = (std::max)({size, std::fabs(v.center.x) + v.radius, std::fabs(v.center.y) + v.radius});
  Axis_steps steps(scaled);
  steps.take_corners(std::sin((std::max)(corner - SAME, 0.0) / 2), ROOM * size);
  const double most = unit.in(limit) / 2;
  std::vector<Thin_stretch> result = steps.thinner_than(most - ROOM * size, most);
  for (Thin_stretch& stretch : result) {
    stretch.length = unit.out(stretch.length);
    for (Medial_sample& s : stretch.samples) s.center = unit.out(s.center), s.radius = unit.out(s.radius);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const Thin_stretch& a, const Thin_stretch& b) { return a.disc().radius < b.disc().radius; });
  return result;
}

}  // namespace CGAL::Bounding_arcs
