// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arcs of eight segments with few leaves each at once, a lane a segment; and what arcs of more leaves need of their
// segments: C(middle) and the widening.  The same bits as those of segments one by one (arc_batch.h).

#ifndef BOUNDING_ARCS_LIBRARY_TREE_BATCH_FEW_ARCS_H
#define BOUNDING_ARCS_LIBRARY_TREE_BATCH_FEW_ARCS_H

#include "Arc_points.h"
#include "arc_batch.h"

#include "../../spiral/accurate_point.h"
#include "Batch_questions.h"

#include <cstddef>

namespace CGAL::Bounding_arcs::filter {

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
