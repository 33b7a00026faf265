// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points, joints and bulges of consecutive pieces of a spiral segment at once, in plain loops without branches: narrow
// forms for all, and wide ones for those groups of eight that have a piece which is not narrow.  A piece's numbers are
// the same bits in every batch and on every instruction set.

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARC_BATCH_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_ARC_BATCH_H

#include "Arc_points.h"
#include "Bca_arcs.h"
#include "Bilens_arcs.h"
#include "Spiral_fat_arc_arcs.h"
#include "bound_batch.h"

#include "../../spiral/accurate_point.h"
#include "Batch_questions.h"

#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

/// The local polynomial's way from C(middle) to sigma, in its own unit.
template <int KIND>
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Xy<double> local_way(const Local_coefficients<double>& c, double sigma) {
  constexpr int DEGREE = degree_of_kind(KIND);
  double x = c.x[DEGREE], y = c.y[DEGREE];
#pragma GCC unroll 16
  for (int k = DEGREE - 1; k >= 1; --k) {
    x = c.x[k] + sigma * x;
    y = c.y[k] + sigma * y;
  }
  if constexpr (is_rational_kind(KIND)) {
    double w = c.w[DEGREE];
#pragma GCC unroll 16
    for (int k = DEGREE - 1; k >= 0; --k) w = c.w[k] + sigma * w;
    x = x / w;
    y = y / w;
  }
  return {sigma * x, sigma * y};
}

template <class Isa, int KIND>
void make_points(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t count,
                 double* __restrict px, double* __restrict py) {
  for (std::size_t j = 0; j < count; ++j) {
    const Xy<double> way = local_way<KIND>(curve.form.coefficients, curve.direction * (breaks[j] - curve.middle));
    px[j] = points.middle.x + points.unit.x * way.x;
    py[j] = points.middle.y + points.unit.y * way.y;
  }
}

/// Where a joint over the unit chord is over the chord from p to p + d.
/// \param direction,turn of the segment's curve
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Xy<double> joint_place(const Joint_side& side, double direction, double turn,
                                                               double px, double py, double dx, double dy) {
  // a joint is p + (q - p) z from the tight end p, and q + (p - q) (1 - z) from the flat one
  const double re = (0.5 - 0.5 * direction) + direction * side.x, im = turn * side.y;
  return {px + (re * dx - im * dy), py + (re * dy + im * dx)};
}

/// Bulges of groups of eight pieces. \param fails 0 where they hold, else 1
template <class Isa, class Arcs, int KIND, bool WIDE, std::size_t SIZE>
void make_bulges(const Local_curve& curve, const Arc_points& points, const double* __restrict begins,
                 const double* __restrict ends, std::size_t groups, double* __restrict inner, double* __restrict outer,
                 double* __restrict fails) {
  const double turn = points.turn, room = points.room, direction = curve.direction, middle = curve.middle;
  for (std::size_t j = 0; j < SIZE * groups; ++j) {
    const double half = 0.5 * (ends[j] - begins[j]), tau = direction * ((begins[j] - middle) + half);
    const Local_piece<double> g = local_piece<KIND>(curve.form.coefficients, tau, half);
    const Arcs a = Arcs::template of<WIDE>(curve.form, g, room);
    inner[j] = turn * a.inner;
    outer[j] = turn * a.outer;
    fails[j] = a.holds ? 0.0 : 1.0;
  }
}

/// Joints and bulges of groups of eight pieces, the bulges from the tight end on.
/// \param x,y the points between the pieces
template <class Isa, class Arcs, int KIND, bool WIDE, std::size_t SIZE>
void make_joints(const Local_curve& curve, const Arc_points& points, const double* __restrict begins,
                 const double* __restrict ends, std::size_t groups, const double* __restrict x,
                 const double* __restrict y, double* __restrict inner_x, double* __restrict inner_y,
                 double* __restrict outer_x, double* __restrict outer_y, double* __restrict inner_tight,
                 double* __restrict inner_flat, double* __restrict outer_tight, double* __restrict outer_flat,
                 double* __restrict fails) {
  const double turn = points.turn, room = points.room, direction = curve.direction, middle = curve.middle;
  for (std::size_t j = 0; j < SIZE * groups; ++j) {
    const double half = 0.5 * (ends[j] - begins[j]), tau = direction * ((begins[j] - middle) + half);
    const Local_piece<double> g = local_piece<KIND>(curve.form.coefficients, tau, half);
    const Local_ends<double> e = local_ends<KIND>(curve.form.coefficients, tau, g);
    const Joint_arcs a = Arcs::template of<WIDE>(curve.form, g, e, room);
    const double dx = x[j + 1] - x[j], dy = y[j + 1] - y[j];
    const Xy<double> in = joint_place(a.inner, direction, turn, x[j], y[j], dx, dy);
    const Xy<double> out = joint_place(a.outer, direction, turn, x[j], y[j], dx, dy);
    inner_x[j] = in.x;
    inner_y[j] = in.y;
    outer_x[j] = out.x;
    outer_y[j] = out.y;
    inner_tight[j] = turn * a.inner.tight;
    inner_flat[j] = turn * a.inner.flat;
    outer_tight[j] = turn * a.outer.tight;
    outer_flat[j] = turn * a.outer.flat;
    fails[j] = a.holds ? 0.0 : 1.0;
  }
}

template <class Isa, class Arcs, int KIND, bool WIDE, std::size_t SIZE>
void make_arcs(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t groups,
               const Arc_places& to, double* fails) {
  if constexpr (!HAS_JOINTS<Arcs>) {
    make_bulges<Isa, Arcs, KIND, WIDE, SIZE>(curve, points, breaks, breaks + 1, groups, to.inner.bulge, to.outer.bulge,
                                             fails);
  } else {
    const bool tight_first = curve.direction > 0;
    const auto tight = [=](const Side_places& s) { return tight_first ? s.bulge : s.second_bulge; };
    const auto flat = [=](const Side_places& s) { return tight_first ? s.second_bulge : s.bulge; };
    make_joints<Isa, Arcs, KIND, WIDE, SIZE>(curve, points, breaks, breaks + 1, groups, to.x, to.y, to.inner.joint_x,
                                             to.inner.joint_y, to.outer.joint_x, to.outer.joint_y, tight(to.inner),
                                             flat(to.inner), tight(to.outer), flat(to.outer), fails);
  }
}

/// The arcs of up to 64 pieces.
/// \param breaks count + 1 parameters, and behind them as many more as a multiple of eight pieces takes
/// \tparam SIZE pieces in a group: those of the widest registers, or 1 for few pieces
/// \return a bit a piece, the first lowest, that is not made: neither form holds, or the widening might be too small
template <class Isa, class Arcs, int KIND, std::size_t SIZE = GROUP<double>>
std::uint64_t arc_batch(const Local_curve& curve, const Arc_points& points, const double* breaks, std::size_t count,
                        const Arc_places& to) {
  constexpr std::size_t COLUMNS = HAS_JOINTS<Arcs> ? 8 : 2;
  const std::size_t groups = (count + SIZE - 1) / SIZE;
  alignas(BATCH_ALIGNMENT) double fails[BATCH_SIZE];
  make_points<Isa, KIND>(curve, points, breaks, SIZE * groups + 1, to.x, to.y);
  make_arcs<Isa, Arcs, KIND, false, SIZE>(curve, points, breaks, groups, to, fails);
  double some = 0;
  for (std::size_t j = 0; j < count; ++j) some = some + fails[j];
  if (some == 0) return 0;
  const auto columns = [](const Arc_places& p, std::size_t i) {
    const Side_places& side = i % 2 == 0 ? p.inner : p.outer;
    double* const all[] = {side.bulge, side.joint_x, side.joint_y, side.second_bulge};
    return all[i / 2];
  };
  std::uint64_t open = 0;
  for (std::size_t g = 0; g < groups; ++g) {
    double any = 0, wide[8][SIZE], wide_fails[SIZE];
    const std::size_t asked = count - SIZE * g < SIZE ? count - SIZE * g : SIZE;
    for (std::size_t i = 0; i < asked; ++i) any = any + fails[SIZE * g + i];
    if (any == 0) continue;
    const Arc_places places{
        to.x + SIZE * g, to.y + SIZE * g, {wide[0], wide[2], wide[4], wide[6]}, {wide[1], wide[3], wide[5], wide[7]}};
    make_arcs<Isa, Arcs, KIND, true, SIZE>(curve, points, breaks + SIZE * g, 1, places, wide_fails);
    for (std::size_t i = 0, j = SIZE * g; i < asked; ++i, ++j) {
      if (fails[j] == 0) continue;
      for (std::size_t k = 0; k < COLUMNS; ++k) columns(to, k)[j] = wide[k][i];
      if (wide_fails[i] != 0) open |= std::uint64_t(1) << j;
    }
  }
  return open;
}

// The arcs of eight segments with few leaves each at once, a lane a segment; and what arcs of more leaves need of their
// segments: C(middle) and the widening.  The same bits as those of segments one by one.

template <class Isa> void find_middles(const Few_question& __restrict q, double* __restrict x, double* __restrict y) {
  for (std::size_t j = 0; j < LANES; ++j) {
    const double px[4] = {q.control_x[0].of[j], q.control_x[1].of[j], q.control_x[2].of[j], q.control_x[3].of[j]};
    const double py[4] = {q.control_y[0].of[j], q.control_y[1].of[j], q.control_y[2].of[j], q.control_y[3].of[j]};
    const double t = q.curves.middle.of[j], at_x = accurate_coordinate<3>(px, t), at_y = accurate_coordinate<3>(py, t);
    x[j] = q.is_cubic.of[j] > 0 ? at_x : x[j];
    y[j] = q.is_cubic.of[j] > 0 ? at_y : y[j];
  }
}

template <class Isa, class Arcs, int KIND>
void find_rooms(const Few_question& __restrict q, double* __restrict widening, double* __restrict room,
                double* __restrict coarse_widening, double* __restrict coarse_room) {
  for (std::size_t j = 0; j < LANES; ++j) {
    const Local_form<double> form = q.curves.template form<KIND>(j);
    const Arc_room r = arc_room<Arcs, KIND>(
        form, q.curves.half.of[j], {q.coordinate_size.of[j], q.ulp.of[j], q.most_widening.of[j], q.cut_error.of[j]});
    widening[j] = r.widening;
    room[j] = r.room;
    coarse_widening[j] = r.coarse_widening;
    coarse_room[j] = r.coarse_room;
  }
}

/// Which form serves a piece: the narrow one where it holds, else the wide one, first for the usual room. Numbers, as
/// bools have no vector form.
struct Form_choice {
  double is_narrow, fails;
};
[[nodiscard]] CGAL_BOUNDING_ARCS_INLINE Form_choice choose_form(bool narrow_holds, bool wide_holds,
                                                                bool coarse_narrow_holds, bool coarse_wide_holds) {
  const double narrow = narrow_holds ? 1 : 0, wide = wide_holds ? 1 : 0, coarse_narrow = coarse_narrow_holds ? 1 : 0,
               coarse_wide = coarse_wide_holds ? 1 : 0;
  return {narrow > 0 ? 1
          : wide > 0 ? 0
                     : coarse_narrow,
          narrow + wide > 0                 ? 0.0
          : coarse_narrow + coarse_wide > 0 ? 1.0
                                            : 2.0};
}

template <class Isa, class Arcs, int KIND>
void make_leaf(const Few_question& __restrict q, const Few_answer& __restrict points, std::size_t leaf,
               Leaf_lanes& __restrict to) {
  double* __restrict x = to.x.of, * __restrict y = to.y.of, * __restrict fails = to.fails.of;
  double* __restrict inner_bulge = to.inner.bulge.of, * __restrict outer_bulge = to.outer.bulge.of;
  double *__restrict inner_x = to.inner.joint_x.of, *__restrict inner_y = to.inner.joint_y.of,
                    *__restrict inner_second = to.inner.second_bulge.of;
  double *__restrict outer_x = to.outer.joint_x.of, *__restrict outer_y = to.outer.joint_y.of,
                    *__restrict outer_second = to.outer.second_bulge.of;
  for (std::size_t j = 0; j < LANES; ++j) {
    const Local_form<double> form = q.curves.template form<KIND>(j);
    const double direction = q.curves.direction.of[j], mirror = q.curves.mirror.of[j], turn = direction * mirror,
                 middle = q.curves.middle.of[j], begin = q.breaks[leaf].of[j], end = q.breaks[leaf + 1].of[j];
    const double half = 0.5 * (end - begin), tau = direction * ((begin - middle) + half);
    const Local_piece<double> g = local_piece<KIND>(form.coefficients, tau, half);
    const double room = points.room.of[j], coarse_room = points.coarse_room.of[j];
    const double mirrored = mirror * form.unit, mx = points.middle_x.of[j], my = points.middle_y.of[j];
    const Xy<double> way = local_way<KIND>(form.coefficients, direction * (begin - middle));
    const double px = mx + form.unit * way.x, py = my + mirrored * way.y;
    x[j] = px;
    y[j] = py;
    if constexpr (!HAS_JOINTS<Arcs>) {
      const Arcs n = Arcs::template of<false>(form, g, room), w = Arcs::template of<true>(form, g, room),
                 cn = Arcs::template of<false>(form, g, coarse_room),
                 cw = Arcs::template of<true>(form, g, coarse_room);
      const Form_choice c = choose_form(n.holds, w.holds, cn.holds, cw.holds);
      inner_bulge[j] = turn * (c.is_narrow > 0 ? n.inner : w.inner);
      outer_bulge[j] = turn * (c.is_narrow > 0 ? n.outer : w.outer);
      fails[j] = c.fails;
    } else {
      const Local_ends<double> e = local_ends<KIND>(form.coefficients, tau, g);
      const Joint_arcs n = Arcs::template of<false>(form, g, e, room), w = Arcs::template of<true>(form, g, e, room),
                       cn = Arcs::template of<false>(form, g, e, coarse_room),
                       cw = Arcs::template of<true>(form, g, e, coarse_room);
      const Form_choice c = choose_form(n.holds, w.holds, cn.holds, cw.holds);
      const Xy<double> last = local_way<KIND>(form.coefficients, direction * (end - middle));
      const double dx = (mx + form.unit * last.x) - px, dy = (my + mirrored * last.y) - py;
      const auto chosen = [&](const Joint_side& a, const Joint_side& b) {
        return Joint_side{c.is_narrow > 0 ? a.x : b.x, c.is_narrow > 0 ? a.y : b.y, c.is_narrow > 0 ? a.tight : b.tight,
                          c.is_narrow > 0 ? a.flat : b.flat};
      };
      const Joint_side inner = chosen(n.inner, w.inner), outer = chosen(n.outer, w.outer);
      const Xy<double> in = joint_place(inner, direction, turn, px, py, dx, dy),
                       out = joint_place(outer, direction, turn, px, py, dx, dy);
      inner_x[j] = in.x;
      inner_y[j] = in.y;
      outer_x[j] = out.x;
      outer_y[j] = out.y;
      inner_bulge[j] = turn * (direction > 0 ? inner.tight : inner.flat);
      inner_second[j] = turn * (direction > 0 ? inner.flat : inner.tight);
      outer_bulge[j] = turn * (direction > 0 ? outer.tight : outer.flat);
      outer_second[j] = turn * (direction > 0 ? outer.flat : outer.tight);
      fails[j] = c.fails;
    }
  }
}

/// C(middle) and widenings of eight segments, and the arcs of those with few leaves.
template <class Isa, class Arcs, int KIND> void make_few_arcs(const Few_question& q, Few_answer& answer) {
  answer.middle_x = q.middle_x;
  answer.middle_y = q.middle_y;
  if (q.has_cubics) find_middles<Isa>(q, answer.middle_x.of, answer.middle_y.of);
  find_rooms<Isa, Arcs, KIND>(q, answer.widening.of, answer.room.of, answer.coarse_widening.of, answer.coarse_room.of);
  answer.most_leaves = q.most_leaves;
  for (std::size_t leaf = 0; leaf < q.most_leaves; ++leaf)
    make_leaf<Isa, Arcs, KIND>(q, answer, leaf, answer.leaves[leaf]);
}

}  // namespace CGAL::Bounding_arcs::filter

#endif
