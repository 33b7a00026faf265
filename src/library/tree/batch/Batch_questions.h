// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filter's loops are asked, and what they answer: pieces of one segment in batches, and first levels or few
// arcs of eight segments side by side.  The loops are compiled once (src/library/tree/batch).

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_QUESTIONS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_BATCH_QUESTIONS_H

#include <CGAL/Bounding_arcs_2/number/Bracket.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>
#include <CGAL/Bounding_arcs_2/number/strict_math.h>
#include "../../spiral/Local_curve.h"
#include "../../spiral/Local_figures.h"

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

inline constexpr std::size_t BATCH_SIZE = 64;
inline constexpr std::size_t BATCH_ALIGNMENT = 64;  ///< of arrays: bytes of the widest register

/// Up to 64 pieces: listed, or consecutive and equally long.
struct Batch_pieces {
  std::size_t count = 0;
  const double* begins = nullptr;  ///< piece i is [begins[i], ends[i]], or where null
  const double* ends = nullptr;
  double first = 0, step = 0, last = 0,
         start = 0;       ///< first + k step to first + (k + 1) step, k = start + i, but not beyond last
  bool are_long = false;  ///< likely to turn by too much for narrow forms, which are then not tried
  bool are_kept = true;   ///< upper bounds that are wanted have to be close (CLOSE_BOUND)

  /// The pieces between count + 1 breaks.
  [[nodiscard]] static Batch_pieces between(const double* breaks, std::size_t count) {
    return {count, breaks, breaks + 1};
  }

  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double grid(int i) const {
    const double t = first + (start + i) * step;
    return t < last ? t : last;
  }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double begin(int i) const { return begins != nullptr ? begins[i] : grid(i); }
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE double end(int i) const { return begins != nullptr ? ends[i] : grid(i + 1); }
  /// A bit a piece, the first piece in the lowest bit.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE std::uint64_t all() const {
    return ~std::uint64_t(0) >> (BATCH_SIZE - count);
  }
  /// Whether places and lengths are within the errors that a segment's rough form allows for: places, and these and a
  /// half, are exact in float, and the roundings in double of parameters up to 1, four in a length, are far below half
  /// an ulp of float of the step. Less would do; below 2^-20 float decides few pieces, and products may underflow.
  [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE bool may_be_rough() const {
    constexpr double EXACT_PLACES = 0x1p23, PLACE_ROOM = 16;
    constexpr double LEAST_STEP = PLACE_ROOM / EXACT_PLACES;
    static_assert(EXACT_PLACES * 2 * Local_precision<float>::HALF_ULP == 1 &&
                      4 * Local_precision<double>::HALF_ULP / LEAST_STEP <= 0x1p-7 * Local_precision<float>::HALF_ULP,
                  "update the derivation above");
    static_assert(LEAST_STEP == 0x1p-19, "update the derivation in Batch_curve.h");
    return begins == nullptr && step >= LEAST_STEP && !are_long;
  }
};

/// A bit a piece. Pieces in neither word are not decided.
struct Batch_decision {
  std::uint64_t within = 0;  ///< thickness <= eps for certain
  std::uint64_t above = 0;   ///< thickness > eps for certain
  double largest = 0;        ///< upper bound of the thickness of those within
};

/// Numbers that fill a register of the widest set: batches run in groups of these.
template <class Real> inline constexpr std::size_t GROUP = 64 / sizeof(Real);

/// A spiral segment as batches see it: its local curve, and the same in float.
struct Batch_curve {
  Local_curve local;
  const Local_form<float>* rough = nullptr;  ///< its lengths are in units of local.form.unit; null: not to be used
};

/// Segments side by side: doubles that fill a register of the widest set.
inline constexpr std::size_t LANES = BATCH_ALIGNMENT / sizeof(double);

/// One double of each segment.
struct alignas(BATCH_ALIGNMENT) Lane_column {
  double of[LANES];
};

/// The local curves of eight segments of one kind. All lanes are to be set: calculations run in all of them.
struct Curve_lanes {
  Lane_column x[MAX_LOCAL_DEGREE + 1], y[MAX_LOCAL_DEGREE + 1], w[MAX_RATIONAL_DEGREE + 1], across[4], change[2];
  Lane_column unit, numerator_error, least_dot, least_square, kneser_error, turn_rate_error, least_turn_rate,
      least_tangent;
  Lane_column middle, half, direction, mirror;

  /// \pre curve.kind == KIND
  template <int KIND> void set(std::size_t lane, const Local_curve& curve) {
    const Local_form<double>& form = curve.form;
    exchange<KIND>(lane, form, *this, [](const double& number, double& stored) { stored = number; });
    middle.of[lane] = curve.middle;
    half.of[lane] = curve.half;
    direction.of[lane] = curve.direction;
    mirror.of[lane] = curve.mirror;
  }
  /// The form of a lane; in loops over lanes it stays in registers.
  template <int KIND> [[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Local_form<double> form(std::size_t lane) const {
    Local_form<double> f;
    exchange<KIND>(lane, f, *this, [](double& number, const double& stored) { number = stored; });
    if constexpr (is_rational_kind(KIND)) {
      f.coefficients.x[0] = f.coefficients.y[0] = 0;
      f.coefficients.w[0] = 1;
    }
    return f;
  }

 private:
  // Calls copy with every number that a kind has and its place in a lane.
  template <int KIND, class Form, class Lanes, class Copy>
  CGAL_BOUNDING_ARCS_INLINE static void exchange(std::size_t lane, Form& form, Lanes& lanes, const Copy& copy) {
    auto& c = form.coefficients;
    for (int k = 1; k <= degree_of_kind(KIND); ++k) {
      copy(c.x[k], lanes.x[k].of[lane]);
      copy(c.y[k], lanes.y[k].of[lane]);
      if constexpr (is_rational_kind(KIND)) copy(c.w[k], lanes.w[k].of[lane]);
    }
    if constexpr (KIND == 3) {
      for (int k = 0; k < 4; ++k) copy(c.across[k], lanes.across[k].of[lane]);
      for (int k = 0; k < 2; ++k) copy(c.change[k], lanes.change[k].of[lane]);
    }
    copy(form.unit, lanes.unit.of[lane]);
    copy(form.numerator_error, lanes.numerator_error.of[lane]);
    copy(form.least_dot, lanes.least_dot.of[lane]);
    copy(form.least_square, lanes.least_square.of[lane]);
    copy(form.kneser_error, lanes.kneser_error.of[lane]);
    copy(form.turn_rate_error, lanes.turn_rate_error.of[lane]);
    copy(form.least_turn_rate, lanes.least_turn_rate.of[lane]);
    copy(form.least_tangent, lanes.least_tangent.of[lane]);
  }
};

/// Puts segments side by side, those of one kind that follow each other.
/// \param serves serves(i) tells whether segment i is asked for
/// \param set set(lane, i) sets what is asked of it beside its curve
/// \param ask ask(kind, places, size) is called for segments places[0], ..., places[size - 1] in the first lanes; the
///   others repeat the first one
template <class Spiral, class Serves, class Set, class Ask>
void for_lanes(const Spiral* first, std::size_t count, Curve_lanes& curves, const Serves& serves, const Set& set,
               const Ask& ask) {
  std::size_t places[LANES], size = 0;
  int kind = 0;
  const auto put = [&](std::size_t lane, std::size_t i, const Local_curve& curve) {
    for_kind(curve.kind, [&](auto of_kind) { curves.template set<of_kind()>(lane, curve); });
    set(lane, i);
  };
  const auto ask_all = [&] {
    for (std::size_t lane = size; lane < LANES; ++lane) put(lane, places[0], first[places[0]].local_curve());
    ask(kind, places, size);
    size = 0;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Local_curve curve = first[i].local_curve();
    if (curve.kind == 0 || !serves(i)) continue;
    if (size > 0 && (size == LANES || curve.kind != kind)) ask_all();
    kind = curve.kind;
    places[size] = i;
    put(size++, i, curve);
  }
  if (size > 0) ask_all();
}

/// The last level whose pieces are likely to turn by too much for narrow forms: a segment turns by some half of a right
/// angle as a rule. Were they tried first everywhere, coarse builds would take 2 to 9 per cent longer.
inline constexpr int LAST_LONG_LEVEL = 3;

/// Levels that are decided side by side.
inline constexpr int TOP_LEVELS = 4;
static_assert(TOP_LEVELS == LAST_LONG_LEVEL + 1, "they are decided by the wide form");
/// Room for their nodes. Node 1 is the root, and nodes 2 i and 2 i + 1 are the halves of node i.
inline constexpr std::size_t TOP_NODES = std::size_t(1) << TOP_LEVELS;

/// What is to be decided of eight segments: their grids, see Spiral_grid, and how thick leaves may be.
struct Top_question {
  Curve_lanes curves;
  Lane_column first, length, last, eps;
  double looseness = HUGE_VAL;  ///< 0 where upper bounds are kept, and have to be close (CLOSE_BOUND); no flag, for
                                ///< which compilers would make two loops and leave one of them in narrow registers
};

/// What was decided of the first levels.
struct Top_answer {
  Top_answer() {}  // NOLINT: nothing is set before it is known

  std::uint64_t above[LANES];    ///< bit i: node i is there, and thicker than eps; bit 0 is always set
  int levels;                    ///< that were looked at
  std::uint64_t open[LANES];     ///< bit i: node i is there, and undecided
  Lane_column largest;           ///< upper bound of the thickness of leaves that were decided
  Lane_column upper[TOP_NODES];  ///< of the thickness of each node that is there in some lane
};

/// Leaves of a segment whose arcs are made side by side with others', at most.
inline constexpr std::size_t FEW_LEAVES = 8;

/// What is asked of eight segments.
struct Few_question {
  Curve_lanes curves;
  Lane_column coordinate_size, ulp, most_widening, cut_error;  ///< Point_sizes
  Lane_column middle_x, middle_y;                              ///< C(middle), where it is not to be calculated
  Lane_column control_x[4], control_y[4];                      ///< of cubics for which it is
  Lane_column is_cubic;                                        ///< 1 there, else 0
  bool has_cubics = false;
  Lane_column breaks[FEW_LEAVES + 1];  ///< the ends of leaves, the last one again where there are fewer
  std::size_t most_leaves = 0;         ///< of segments whose arcs are asked for
};

/// A side of eight regions.
struct Side_lanes {
  Lane_column bulge, joint_x, joint_y, second_bulge;
};
/// Leaf i of each segment.
struct Leaf_lanes {
  Lane_column x, y;  ///< where it begins
  Side_lanes inner, outer;
  Lane_column fails;  ///< 0 where the usual widening is enough, 1 where that of coarse pieces is, else 2
};
struct Few_answer {
  Few_answer() {}  // NOLINT: nothing is set before it is known

  std::size_t most_leaves;  ///< of segments whose arcs were made
  Lane_column middle_x, middle_y, widening, room, coarse_widening, coarse_room;
  Leaf_lanes leaves[FEW_LEAVES];
};

/// The points of a segment in doubles, for arcs that are made in batches, and their widening.
struct Arc_points {
  Xy<double> middle;    ///< C(middle)
  Xy<double> unit;      ///< of the local polynomial, mirrored as that is
  double turn = 1;      ///< -1 where arcs turn right in the direction of t
  double widening = 0;  ///< as a rule 8 ulp of the largest coordinate
  double room = -1;     ///< what bulges and joints may err by, in units of the local polynomial; negative: none
};

/// What a segment's points tell of its regions beside its local curve.
struct Point_sizes {
  double coordinate_size;  ///< the largest |coordinate|
  double ulp;              ///< of it
  double most_widening;    ///< that of regions made one by one: there is no room where more is needed
  double cut_error;        ///< see Bezier_spiral_2::cut_error
};
/// The widening of regions, and what their bulges and joints may err by in units of the local polynomial; negative:
/// they are not to be made here. Coarse pieces have more of both.
struct Arc_room {
  double widening, room, coarse_widening, coarse_room;
};
/// Where the numbers of one side of consecutive pieces go, one place a piece; joints and second bulges only of methods
/// that have them.
struct Side_places {
  double *bulge, *joint_x, *joint_y, *second_bulge;
};

/// One place a piece, with its first point. Up to a multiple of eight places are written, and one more of points, the
/// last ones with numbers that nobody reads.
struct Arc_places {
  double *x, *y;
  Side_places inner, outer;
};

// Formulas for thickness, and for arcs; src/library/tree/batch has them.
struct Bca_batch;
struct Bilens_batch;
struct Spiral_fat_arc_batch;
struct Bca_arcs;
struct Bilens_arcs;
struct Spiral_fat_arc_arcs;

/// Whether sides of regions have two arcs.
template <class Arcs> inline constexpr bool HAS_JOINTS = true;
template <> inline constexpr bool HAS_JOINTS<Bca_arcs> = false;

using Bound_function = Bracket (*)(const Local_curve&, double begin, double end, double eps, bool is_long);
using Batch_function = Batch_decision (*)(const Batch_curve&, const Batch_pieces& pieces, double eps, double* upper);
using Top_function = void (*)(const Top_question&, Top_answer&);

using Arc_function = std::uint64_t (*)(const Local_curve&, const Arc_points&, const double* breaks, std::size_t count,
                                       const Arc_places&);
using Lanes_function = void (*)(const Few_question&, Few_answer&);

/// The loops as they are compiled for one instruction set; defined in src/library/tree/batch_loops.cpp.
template <class Isa, class Method> [[nodiscard]] Batch_function batch_function(int kind);
template <class Isa, class Method> [[nodiscard]] Top_function top_function(int kind);
template <class Isa, class Arcs> [[nodiscard]] Arc_function arc_function(int kind);
template <class Isa, class Arcs> [[nodiscard]] Lanes_function lanes_function(int kind);
/// The loops for few pieces; defined in src/library/tree/single_loops.cpp.
template <class Method> [[nodiscard]] Bound_function one_function(int kind);
template <class Arcs> [[nodiscard]] Arc_function few_function(int kind);
/// What regions of a segment may err by, see Arc_points.h. \pre curve.kind > 0
template <class Arcs> [[nodiscard]] Arc_room arc_room(const Local_curve& curve, const Point_sizes& sizes);
/// Sets the form in float, where it serves.
[[nodiscard]] bool make_rough_form(const Local_curve& curve, Local_form<float>& rough);

}  // namespace CGAL::Bounding_arcs::filter

#endif
