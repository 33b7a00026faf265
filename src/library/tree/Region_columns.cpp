// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Segment_regions.h.

#include "batch/Arcs_ahead.h"
#include "batch/Batch_functions.h"
#include "batch/Batch_questions.h"

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/region/Bca.h>
#include <CGAL/Bounding_arcs_2/region/Bilens.h>
#include <CGAL/Bounding_arcs_2/region/Spiral_fat_arc.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_regions.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

namespace CGAL::Bounding_arcs::internal {
/// Makes the regions of one segment one by one.
class Plain_segment {
 public:
  Plain_segment(const Region_source& source, std::size_t segment)
      : segment_(segment), ends_(source.ends(segment)), start_(source.point(segment, ends_.first)),
        end_(source.point(segment, ends_.last)) {}
  Plain_segment(const Bezier_spiral_2<double>& spiral, std::size_t segment)
      : segment_(segment), ends_{spiral.first(), spiral.last()}, start_(spiral.point(ends_.first)),
        end_(spiral.point(ends_.last)) {}

  double make(const Region_source& source, Region_columns& to, std::size_t row, std::size_t count) const {
    for (std::size_t j = row; j <= row + count; ++j) set_point(to, j, source.point(segment_, to.t[j]));
    std::vector<std::size_t> all;
    for (std::size_t j = row; j < row + count; ++j) all.push_back(j);
    complete(source, to, row, count, all);
    return source.widening(segment_);
  }
  /// Sets the segment's own ends, the regions of rows that are open, and zeros behind the last region.
  void complete(const Region_source& source, Region_columns& to, std::size_t row, std::size_t count,
                const std::vector<std::size_t>& open) const {
    if (to.t[row] == ends_.first) set_point(to, row, start_);
    if (to.t[row + count] == ends_.last) set_point(to, row + count, end_);
    for (const std::size_t j : open) make_one(source, to, j);
    for (auto* side : {&to.inner, &to.outer})  // batches leave numbers of no meaning there
      for (auto* column : {&side->bulge, &side->joint_x, &side->joint_y, &side->second_bulge})
        if (!column->empty()) (*column)[row + count] = 0;
  }

 private:
  static void set_point(Region_columns& to, std::size_t j, const Xy<double>& p) {
    to.x[j] = p.x;
    to.y[j] = p.y;
  }
  void make_one(const Region_source& source, Region_columns& to, std::size_t j) const {
    const Arc_region_2 r =
        source.region(segment_, to.t[j], to.t[j + 1], {to.x[j], to.y[j]}, {to.x[j + 1], to.y[j + 1]});
    const auto set_side = [&](const Arc_region_2::Side& side, Region_columns::Side& columns) {
      columns.bulge[j] = side.bulges[0];
      if (!source.has_joints) return;
      const Xy<double> joint = side.size == 2 ? side.joint : r.to;
      columns.joint_x[j] = joint.x;
      columns.joint_y[j] = joint.y;
      columns.second_bulge[j] = side.bulges[1];
    };
    if (r.form != Region_form::BCA) to.form = r.form;
    set_side(r.inner, to.inner);
    set_side(r.outer, to.outer);
  }

  std::size_t segment_;
  Region_source::Ends ends_;
  Xy<double> start_, end_;
};

/// Makes the regions of one segment in batches, where it is served.
template <class Arcs> class Batch_segment {
 public:
  /// \param points what was found of the segment ahead
  Batch_segment(const Region_source& source, std::size_t segment, bool is_whole,
                const std::optional<filter::Both_points>& points = std::nullopt)
      : plain_((*source.served)[segment], segment),
        filter_(points ? filter::Arc_filter<Arcs>(source.set, (*source.served)[segment], *points)
                       : filter::Arc_filter<Arcs>(source.set, (*source.served)[segment], is_whole)) {}

  double make(const Region_source& source, Region_columns& to, std::size_t row, std::size_t count) const {
    if (!filter_.serves()) return plain_.make(source, to, row, count);
    const auto places = [row](Region_columns::Side& c) {
      if constexpr (!filter::HAS_JOINTS<Arcs>) return filter::Side_places{&c.bulge[row], nullptr, nullptr, nullptr};
      else return filter::Side_places{&c.bulge[row], &c.joint_x[row], &c.joint_y[row], &c.second_bulge[row]};
    };
    std::vector<std::size_t> open;
    double widening = filter_.make(&to.t[row], count, {&to.x[row], &to.y[row], places(to.inner), places(to.outer)},
                                   [&](std::size_t j) { open.push_back(row + j); });
    if (open.size() < count) to.form = filter::FORM<Arcs>;
    if (!open.empty()) {
      double longest = 0;
      for (const std::size_t j : open)
        longest = (std::max)(longest, stable_norm(Xy<double>{to.x[j + 1] - to.x[j], to.y[j + 1] - to.y[j]}));
      widening = filter_.with_single(widening, longest);
    }
    plain_.complete(source, to, row, count, open);
    return widening;
  }

 private:
  Plain_segment plain_;
  filter::Arc_filter<Arcs> filter_;
};

namespace {

void resize_columns(Region_columns& to, std::size_t size, bool has_joints) {
  for (auto* column : {&to.t, &to.x, &to.y, &to.inner.bulge, &to.outer.bulge}) column->resize(size);
  for (auto* side : {&to.inner, &to.outer})
    for (auto* column : {&side->joint_x, &side->joint_y, &side->second_bulge}) column->resize(has_joints ? size : 0);
}

constexpr std::size_t AHEAD = 64;  // segments

// Makes the regions of all segments one by one.
void make_plain_rows(const Region_source& source,
                     const std::function<void(std::size_t segment, double* ends)>& write_ends, Region_columns& to) {
  for (std::size_t i = 0; i < source.size; ++i) {
    const std::size_t row = to.first[i];
    to.t[row] = source.ends(i).first;
    write_ends(i, &to.t[row + 1]);
    to.widening[i] = Plain_segment(source, i).make(source, to, row, to.first[i + 1] - row - 1);
  }
}

template <class Arcs>
void make_batch_rows(const Region_source& source,
                     const std::function<void(std::size_t segment, double* ends)>& write_ends, Region_columns& to) {
  const std::vector<Bezier_spiral_2<double>>& spirals = *source.served;
  filter::Arcs_ahead<Arcs> ahead(source.set);
  for (std::size_t i = 0; i < spirals.size(); ++i) {
    if (i % AHEAD == 0) {
      const std::size_t count = (std::min)(AHEAD, spirals.size() - i);
      for (std::size_t j = i; j < i + count; ++j) {
        to.t[to.first[j]] = spirals[j].first();
        write_ends(j, &to.t[to.first[j] + 1]);
      }
      ahead.look(&spirals[i], count, &to.first[i], to.t.data());
    }
    if (ahead.make(i % AHEAD, to, to.widening[i])) continue;
    const std::size_t row = to.first[i], count = to.first[i + 1] - row - 1;
    to.widening[i] = Batch_segment<Arcs>(source, i, count == 1, ahead.points(i % AHEAD)).make(source, to, row, count);
  }
}

}  // namespace

struct Segment_regions::State {
  Region_source source;
  std::variant<std::monostate, Plain_segment, Batch_segment<filter::Formulas<Bca>::Arcs>,
               Batch_segment<filter::Formulas<Bilens>::Arcs>, Batch_segment<filter::Formulas<Spiral_fat_arc>::Arcs>>
      segment;
};

Segment_regions::Segment_regions(const Region_source& source) : state_(new State{source, {}}) {}
Segment_regions::Segment_regions(const Segment_regions& other) : state_(new State(*other.state_)) {}
Segment_regions::Segment_regions(Segment_regions&&) noexcept = default;
Segment_regions& Segment_regions::operator=(Segment_regions other) noexcept {
  state_ = std::move(other.state_);
  return *this;
}
Segment_regions::~Segment_regions() = default;

void Segment_regions::resize(Region_columns& to, std::size_t size) const {
  resize_columns(to, size, state_->source.has_joints);
}

void Segment_regions::open(std::size_t segment, bool is_whole) {
  const Region_source& source = state_->source;
  if (source.served == nullptr) state_->segment.emplace<Plain_segment>(source, segment);
  else
    filter::with_formulas(source.method, [&](auto f) {
      state_->segment.emplace<Batch_segment<typename decltype(f)::Arcs>>(source, segment, is_whole);
    });
}

double Segment_regions::make(Region_columns& to, std::size_t row, std::size_t count) const {
  return std::visit(
      [&](const auto& segment) -> double {
        if constexpr (std::is_same_v<std::decay_t<decltype(segment)>, std::monostate>) return 0;
        else return segment.make(state_->source, to, row, count);
      },
      state_->segment);
}

void make_rows(const Region_source& source, const std::function<void(std::size_t segment, double* ends)>& write_ends,
               Region_columns& to) {
  const std::size_t rows = to.first.back();
  resize_columns(to, rows + Segment_regions::PADDING, source.has_joints);
  static_assert(Segment_regions::PADDING == filter::ARC_PADDING, "batches write as many");
  to.form = Region_form::BCA;
  to.widening.resize(source.size);
  if (source.served == nullptr) make_plain_rows(source, write_ends, to);
  else
    filter::with_formulas(source.method,
                          [&](auto f) { make_batch_rows<typename decltype(f)::Arcs>(source, write_ends, to); });
  resize_columns(to, rows, source.has_joints);
}

}  // namespace CGAL::Bounding_arcs::internal
