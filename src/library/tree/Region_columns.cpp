// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Segment_regions.h.
//
//   segments with few leaves: eight of them side by side
//   others: in batches of pieces, where there are formulas and a local curve; coarse pieces with more room
//   what these leave open: one by one

#include "batch/Batch_functions.h"
#include "batch/Batch_questions.h"

#include <CGAL/Bounding_arcs_2/number/stable_norm.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Region_columns.h>
#include <CGAL/Bounding_arcs_2/tree/internal/Segment_regions.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs::internal {
using filter::Arc_functions;

/// What arc_room asks of a segment's points.
[[nodiscard]] static filter::Point_sizes point_sizes(const Bezier_spiral_2<double>& spiral) {
  constexpr double OF_SINGLE = 4;  // of point errors: widening_of_single_regions (tree/internal/Segment_regions.h)
  const double size = spiral.coordinate_size();
  return {size, ulp_of(size), OF_SINGLE * spiral.point_error(), spiral.cut_error()};
}

/// Points of a segment, for its usual pieces and for coarse ones.
struct Both_points {
  filter::Arc_points usual, coarse;

  Both_points() = default;
  /// \param at_middle C(curve.middle), each coordinate within half an ulp and less
  Both_points(const Local_curve& curve, const Xy<double>& at_middle, const filter::Arc_room& r) {
    const double unit = curve.form.unit;
    usual = {at_middle, {unit, curve.mirror * unit}, curve.direction * curve.mirror, r.widening, r.room};
    coarse = usual;
    coarse.widening = r.coarse_widening;
    coarse.room = r.coarse_room;
  }
};

static void set_point(Region_columns& to, std::size_t row, const Xy<double>& p) {
  to.x[row] = p.x;
  to.y[row] = p.y;
}

/// Makes the regions of one segment.
class One_segment {
  using Spiral = Bezier_spiral_2<double>;

 public:
  /// Makes them one by one.
  One_segment(const Region_source& source, std::size_t segment)
      : segment_(segment), ends_(source.ends(segment)), start_(source.point(segment, ends_.first)),
        end_(source.point(segment, ends_.last)) {}
  /// Makes them in batches, where there are formulas, a local curve and room.
  /// \param points what was found of the segment ahead
  /// \param is_whole the segment is asked for as one piece: its ends are known, and bulges need no points
  One_segment(const Arc_functions& functions, const Spiral& spiral, std::size_t segment,
              const std::optional<Both_points>& points, bool is_whole)
      : segment_(segment), ends_{spiral.first(), spiral.last()}, start_(spiral.point(ends_.first)),
        end_(spiral.point(ends_.last)), form_(functions.form), curve_(spiral.local_curve()),
        many_(functions.many(curve_.kind)), few_(functions.few(curve_.kind)) {
    if (many_ == nullptr) return;
    const bool needs_middle = !is_whole || functions.has_joints;
    points_ = points ? *points
                     : Both_points(curve_, needs_middle ? spiral.end_point(curve_.middle) : Xy<double>(),
                                   functions.room(curve_, point_sizes(spiral)));
    if (!(points_.usual.room > 0)) many_ = nullptr;
  }

  /// Sets rows row, ..., row + count - 1, and zeros for a region behind them.
  /// \return how far the exact curve may be from these regions
  double make(const Region_source& source, Region_columns& to, std::size_t row, std::size_t count) const {
    std::vector<std::size_t> open;
    const double widening =
        many_ != nullptr ? make_batches(to, row, count, open) : make_points(source, to, row, count, open);
    if (to.t[row] == ends_.first) set_point(to, row, start_);
    if (to.t[row + count] == ends_.last) set_point(to, row + count, end_);
    for (const std::size_t j : open) make_one(source, to, j);
    for (auto* side : {&to.inner, &to.outer})  // batches leave numbers of no meaning there
      for (auto* column : {&side->bulge, &side->joint_x, &side->joint_y, &side->second_bulge})
        if (!column->empty()) (*column)[row + count] = 0;
    return widening;
  }

 private:
  // \param open the rows whose regions are left to be made
  double make_points(const Region_source& source, Region_columns& to, std::size_t row, std::size_t count,
                     std::vector<std::size_t>& open) const {
    for (std::size_t j = row; j <= row + count; ++j) {
      set_point(to, j, source.point(segment_, to.t[j]));
      if (j < row + count) open.push_back(j);
    }
    return source.widening(segment_);
  }
  double make_batches(Region_columns& to, std::size_t row, std::size_t count, std::vector<std::size_t>& open) const {
    constexpr std::size_t FEW = 2;  // up to which a loop without wide registers is quicker
    const filter::Arc_function function = count <= FEW ? few_ : many_;
    double widening = points_.usual.widening, longest = 0;
    for (std::size_t i = row, end = row + count; i < end; i += filter::BATCH_SIZE) {
      std::uint64_t left =
          function(curve_, points_.usual, &to.t[i], (std::min)(end - i, filter::BATCH_SIZE), places(to, i));
      for (std::size_t j = i; left != 0; ++j, left >>= 1) {
        if ((left & 1) == 0) continue;
        if (few_(curve_, points_.coarse, &to.t[j], 1, places(to, j)) != 0) open.push_back(j);
        else widening = points_.coarse.widening;
      }
    }
    if (open.size() < count) to.form = form_;
    for (const std::size_t j : open)
      longest = (std::max)(longest, stable_norm(Xy<double>{to.x[j + 1] - to.x[j], to.y[j + 1] - to.y[j]}));
    return open.empty() ? widening : with_single(widening, longest);
  }
  [[nodiscard]] static filter::Arc_places places(Region_columns& to, std::size_t row) {
    const auto side = [row](Region_columns::Side& c) {
      if (c.joint_x.empty()) return filter::Side_places{&c.bulge[row], nullptr, nullptr, nullptr};
      return filter::Side_places{&c.bulge[row], &c.joint_x[row], &c.joint_y[row], &c.second_bulge[row]};
    };
    return {&to.x[row], &to.y[row], side(to.inner), side(to.outer)};
  }
  // What the widening is with regions over its points that were made one by one, from shapes exact to half an ulp by
  // formulas without cancellation: their joints and bulges err by the roundings of no more than 64 operations.
  // \param widening of the others \param chord the longest of these pieces has
  [[nodiscard]] double with_single(double widening, double chord) const {
    constexpr double OF_SINGLE = 64 * Local_precision<double>::HALF_ULP;
    return (std::max)(widening, points_.usual.widening + OF_SINGLE * chord / 2 - points_.usual.room * curve_.form.unit);
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
  Region_form form_ = Region_form::BCA;  // of regions that are made in batches
  Local_curve curve_;
  Both_points points_;
  filter::Arc_function many_ = nullptr;  // null: there are no batches
  filter::Arc_function few_ = nullptr;
};

/// Makes the regions of segments with few leaves, eight segments at a time, and finds for others what their batches
/// need.
class Arcs_ahead {
  using Spiral = Bezier_spiral_2<double>;
  static constexpr std::size_t LANES = filter::LANES, FEW_LEAVES = filter::FEW_LEAVES;

 public:
  static constexpr std::size_t MOST = 64;  ///< segments to look at

  explicit Arcs_ahead(const Arc_functions& functions) : functions_(functions) {}

  /// Looks at segments first[0], ..., first[count - 1], and forgets those before.
  /// \param rows the first row of each segment and, behind them, where the last one ends
  /// \param t the parameters of rows
  void look(const Spiral* first, std::size_t count, const std::size_t* rows, const double* t) {
    first_ = first;
    rows_ = rows;
    slots_.assign(count, NONE);
    answers_.clear();
    answers_.reserve(count / LANES + 1);
    filter::Few_question question;
    filter::Few_question& q = question;
    const auto set = [&](std::size_t lane, std::size_t i) {
      const std::size_t leaves = leaves_of(i);
      const filter::Point_sizes sizes = point_sizes(first[i]);
      q.coordinate_size.of[lane] = sizes.coordinate_size;
      q.ulp.of[lane] = sizes.ulp;
      q.most_widening.of[lane] = sizes.most_widening;
      q.cut_error.of[lane] = sizes.cut_error;
      for (std::size_t k = 0; k <= FEW_LEAVES; ++k) q.breaks[k].of[lane] = t[rows[i] + (std::min)(k, leaves)];
      set_middle(q, lane, first[i], leaves > 1 || functions_.has_joints);
    };
    const auto ask = [&](int kind, const std::size_t* places, std::size_t size) {
      if (const filter::Lanes_function function = functions_.lanes(kind)) {
        std::size_t with[FEW_LEAVES + 1] = {};  // so many leaves
        for (std::size_t lane = 0; lane < size; ++lane) {
          slots_[places[lane]] = LANES * answers_.size() + lane;
          if (leaves_of(places[lane]) <= FEW_LEAVES) ++with[leaves_of(places[lane])];
        }
        q.most_leaves = best_most(with, size);
        function(q, answers_.emplace_back());
      }
      q.has_cubics = false;
    };
    filter::for_lanes(
        first, count, q.curves, [](std::size_t) { return true; }, set, ask);
  }
  /// Sets the rows of segment i, if that has few leaves, all of which could be made.
  /// Batches write beyond their rows, so segments are to be made in their order.
  [[nodiscard]] bool make(std::size_t i, Region_columns& columns, double& widening) const {
    if (slots_[i] == NONE) return false;
    const std::size_t leaves = leaves_of(i), lane = slots_[i] % LANES;
    const filter::Few_answer& a = answers_[slots_[i] / LANES];
    if (leaves > a.most_leaves) return false;
    double fails = 0;
    for (std::size_t k = 0; k < leaves; ++k) fails = (std::max)(fails, a.leaves[k].fails.of[lane]);
    if (!(a.room.of[lane] > 0) || fails > 1) return false;
    widening = fails > 0 ? a.coarse_widening.of[lane] : a.widening.of[lane];
    const std::size_t row = rows_[i], last = row + leaves;
    const bool has_joints = functions_.has_joints;
    set_point(columns, row, first_[i].point(first_[i].first()));
    set_point(columns, last, first_[i].point(first_[i].last()));
    for (std::size_t k = 0; k < leaves; ++k) {
      const filter::Leaf_lanes& leaf = a.leaves[k];
      if (k > 0) set_point(columns, row + k, {leaf.x.of[lane], leaf.y.of[lane]});
      set_side(lane, leaf.inner, has_joints, columns.inner, row + k);
      set_side(lane, leaf.outer, has_joints, columns.outer, row + k);
    }
    for (auto* side : {&columns.inner, &columns.outer}) {
      side->bulge[last] = 0;
      if (has_joints) side->joint_x[last] = side->joint_y[last] = side->second_bulge[last] = 0;
    }
    columns.form = functions_.form;
    return true;
  }
  /// The points of segment i where they leave room for arcs.
  [[nodiscard]] std::optional<Both_points> points(std::size_t i) const {
    const std::size_t lane = slots_[i] % LANES;
    if (slots_[i] == NONE || !(answers_[slots_[i] / LANES].room.of[lane] > 0)) return std::nullopt;
    const filter::Few_answer& a = answers_[slots_[i] / LANES];
    return Both_points(first_[i].local_curve(), {a.middle_x.of[lane], a.middle_y.of[lane]},
                       {a.widening.of[lane], a.room.of[lane], a.coarse_widening.of[lane], a.coarse_room.of[lane]});
  }

 private:
  [[nodiscard]] std::size_t leaves_of(std::size_t i) const { return rows_[i + 1] - rows_[i] - 1; }
  // How many leaves a segment may have for its arcs to be made side by side. Each leaf takes all lanes. The arcs of
  // another segment are a batch of its own, which takes as long as two and a half leaves.
  [[nodiscard]] static std::size_t best_most(const std::size_t (&with)[FEW_LEAVES + 1], std::size_t others) {
    std::size_t best = 0, least = 5 * others;
    for (std::size_t most = 1; most <= FEW_LEAVES; ++most) {
      others -= with[most];
      if (const std::size_t cost = 2 * most + 5 * others; cost < least) {
        least = cost;
        best = most;
      }
    }
    return best;
  }
  static void set_middle(filter::Few_question& q, std::size_t lane, const Spiral& spiral, bool is_wanted) {
    const auto& p = spiral.curve().control_points();
    const bool is_cubic = is_wanted && p.size() == 4 && !spiral.curve().is_rational();
    q.is_cubic.of[lane] = is_cubic ? 1 : 0;
    q.has_cubics = q.has_cubics || is_cubic;
    for (std::size_t k = 0; k < 4; ++k) {
      q.control_x[k].of[lane] = is_cubic ? p[k].x : 0;
      q.control_y[k].of[lane] = is_cubic ? p[k].y : 0;
    }
    const Xy<double> middle = is_wanted && !is_cubic ? spiral.end_point(q.curves.middle.of[lane]) : Xy<double>();
    q.middle_x.of[lane] = middle.x;
    q.middle_y.of[lane] = middle.y;
  }
  static void set_side(std::size_t lane, const filter::Side_lanes& from, bool has_joints, Region_columns::Side& to,
                       std::size_t j) {
    to.bulge[j] = from.bulge.of[lane];
    if (!has_joints) return;
    to.joint_x[j] = from.joint_x.of[lane];
    to.joint_y[j] = from.joint_y.of[lane];
    to.second_bulge[j] = from.second_bulge.of[lane];
  }

  Arc_functions functions_;
  static constexpr std::size_t NONE = ~std::size_t(0);
  const Spiral* first_ = nullptr;
  const std::size_t* rows_ = nullptr;
  std::vector<std::size_t> slots_;  // of each segment: eight times the place of its answer, and its lane there
  std::vector<filter::Few_answer> answers_;
};

static void resize_columns(Region_columns& to, std::size_t size, bool has_joints) {
  for (auto* column : {&to.t, &to.x, &to.y, &to.inner.bulge, &to.outer.bulge}) column->resize(size);
  for (auto* side : {&to.inner, &to.outer})
    for (auto* column : {&side->joint_x, &side->joint_y, &side->second_bulge}) column->resize(has_joints ? size : 0);
}
[[nodiscard]] static std::optional<Arc_functions> arc_functions(const Region_source& source) {
  if (source.served == nullptr) return std::nullopt;
  return filter::with_formulas(
      source.method, [&](auto f) { return std::optional(Arc_functions::of<typename decltype(f)::Arcs>(source.set)); });
}

struct Segment_regions::State {
  Region_source source;
  std::optional<Arc_functions> functions;
  std::optional<One_segment> segment;
};

Segment_regions::Segment_regions(const Region_source& source) : state_(new State{source, arc_functions(source), {}}) {}
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
  State& s = *state_;
  if (s.functions) s.segment.emplace(*s.functions, (*s.source.served)[segment], segment, std::nullopt, is_whole);
  else s.segment.emplace(s.source, segment);
}

double Segment_regions::make(Region_columns& to, std::size_t row, std::size_t count) const {
  return state_->segment->make(state_->source, to, row, count);
}

void make_rows(const Region_source& source, const std::function<void(std::size_t segment, double* ends)>& write_ends,
               Region_columns& to) {
  const std::size_t rows = to.first.back();
  resize_columns(to, rows + Segment_regions::PADDING, source.has_joints);
  static_assert(Segment_regions::PADDING == filter::GROUP<double>, "batches write as many");
  to.form = Region_form::BCA;
  to.widening.resize(source.size);
  const auto functions = arc_functions(source);
  std::optional<Arcs_ahead> ahead;
  if (functions) ahead.emplace(*functions);
  for (std::size_t i = 0; i < source.size; ++i) {
    const std::size_t place = i % Arcs_ahead::MOST, row = to.first[i], count = to.first[i + 1] - row - 1;
    if (place == 0) {
      const std::size_t end = (std::min)(i + Arcs_ahead::MOST, source.size);
      for (std::size_t j = i; j < end; ++j) {
        to.t[to.first[j]] = ahead ? (*source.served)[j].first() : source.ends(j).first;
        write_ends(j, &to.t[to.first[j] + 1]);
      }
      if (ahead) ahead->look(&(*source.served)[i], end - i, &to.first[i], to.t.data());
    }
    if (ahead && ahead->make(place, to, to.widening[i])) continue;
    const One_segment one = ahead ? One_segment(*functions, (*source.served)[i], i, ahead->points(place), count == 1)
                                  : One_segment(source, i);
    to.widening[i] = one.make(source, to, row, count);
  }
  resize_columns(to, rows, source.has_joints);
}

}  // namespace CGAL::Bounding_arcs::internal
