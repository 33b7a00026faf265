// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often each operand runs round both sides of every edge.
//
// An edge that operand k's curves run along m times, forwards less backwards, has m more on its left than on its right.
// A ray tells one edge; where two curves cross and nothing else is there, the others follow:
//
//               B after
//       left(A) | left(A)            with R to the right of A behind the crossing,
//    A before --+-- A after          right of B before: R       right of A before: R + what B counts
//       right(A)| R                  right of B after:  R + what A counts
//               B before
//
// So few edges need rays: one of each connected part, and those at ends where curves touch or more than two meet.

#ifndef CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_WINDINGS_H
#define CGAL_BOUNDING_ARCS_2_BOOLEAN_INTERNAL_EDGE_WINDINGS_H

#include <CGAL/Bounding_arcs_2/boolean/internal/Edge_rays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL::Bounding_arcs::internal {

class Edge_windings {
 public:
  /// \param operand_of_curve numbers below `operands`
  Edge_windings(const Edge_pieces& pieces, Edge_rays& rays, const std::vector<std::uint32_t>& operand_of_curve,
                std::size_t operands)
      : cut_(pieces.cut()), rays_(rays), operand_(operand_of_curve), operands_(operands) {
    const std::size_t edges = cut_.edges().size();
    times_.assign(edges * operands, 0);
    right_.assign(edges * operands, 0);
    is_known_.assign(edges, 0);
    next_member_.assign(edges, Cut_edge::NONE);
    for (auto e = static_cast<std::uint32_t>(edges); e-- > 0;) {
      const Cut_edge& edge = cut_.edges()[e];
      times_[edge.representative * operands + operand_[edge.curve]] += edge.is_against ? -1 : 1;
      if (edge.representative == e) continue;
      next_member_[e] = next_member_[edge.representative];
      next_member_[edge.representative] = e;
    }
    for (std::uint32_t e = 0; e < edges && is_decided_; ++e) {
      if (cut_.edges()[e].representative != e || is_known_[e] != 0) continue;
      ask_ray(e);
      spread();
    }
  }

  /// Whether every edge has been told.
  [[nodiscard]] bool is_decided() const { return is_decided_; }
  /// To the right of the representative of a class, as it runs.
  [[nodiscard]] int right(std::uint32_t representative, std::size_t operand) const {
    return right_[representative * operands_ + operand];
  }
  [[nodiscard]] int left(std::uint32_t representative, std::size_t operand) const {
    return right(representative, operand) + times(representative, operand);
  }
  /// How often an operand runs along a class, forwards less backwards.
  [[nodiscard]] int times(std::uint32_t representative, std::size_t operand) const {
    return times_[representative * operands_ + operand];
  }

 private:
  using Numbers = std::vector<int>;  // by operand

  void ask_ray(std::uint32_t e) {
    const std::optional<Edge_ray>& ray = rays_.from(e);
    if (!ray || (ray->rise == 0 && ray->level == 0)) {
      is_decided_ = false;
      return;
    }
    Numbers number(operands_, 0);
    for (const Ray_hit_of_edge& h : ray->hits)
      for (std::size_t k = 0; k < operands_; ++k) number[k] += h.number * times(h.edge, k);
    int passing = 0;
    for (const Ray_hit_of_edge& h : ray->passing) {
      is_decided_ = is_decided_ && h.edge == e;
      passing += h.number;
    }
    is_decided_ = is_decided_ && passing == ray->rise;
    for (std::size_t k = 0; k < operands_; ++k) {
      // what the ray tells is to the right of a rising edge and of a level one that runs to the right
      right_[e * operands_ + k] = ray->rise > 0 || ray->level > 0 ? number[k] : number[k] - times(e, k);
    }
    know(e);
  }
  void know(std::uint32_t representative) {
    is_known_[representative] = 1;
    for (std::uint32_t e = representative; e != Cut_edge::NONE; e = next_member_[e]) todo_.push_back(e);
  }

  void spread() {
    while (!todo_.empty()) {
      const std::uint32_t e = todo_.back();
      todo_.pop_back();
      const Cut_edge& edge = cut_.edges()[e];
      if (edge.first == Cut_edge::NONE) continue;
      spread_from(e, edge.first);
      spread_from(e, edge.last);
    }
  }
  void spread_from(std::uint32_t known, std::uint32_t cut) {
    Plain_crossing at = cut_.crossing(cut_.cuts()[cut].vertex);
    if (!at.is_plain) return;
    const std::uint32_t before[2] = {cut_.edge_before(at.cut_a), cut_.edge_before(at.cut_b)},
                        after[2] = {cut_.edge_after(at.cut_a), cut_.edge_after(at.cut_b)};
    const auto is_told = [this](std::uint32_t e) { return is_known_[cut_.edges()[e].representative] != 0; };
    if (is_told(before[0]) && is_told(before[1]) && is_told(after[0]) && is_told(after[1])) return;
    const int side = side_of_crossing(at);
    if (side == 0) return;
    const int a = side > 0 ? 0 : 1, b = 1 - a;  // b crosses a from right to left
    const std::uint32_t operand_a = operand_[cut_.edges()[after[a]].curve],
                        operand_b = operand_[cut_.edges()[after[b]].curve];
    Numbers behind(operands_);  // to the right of a behind the crossing
    for (std::size_t k = 0; k < operands_; ++k) behind[k] = right_of(known, k);
    if (known == before[a] && known != after[a]) --behind[operand_b];
    else if (known == after[b] && known != before[b]) --behind[operand_a];
    const auto tell = [&](std::uint32_t e, std::uint32_t more) {
      if (is_told(e)) return;
      const Cut_edge& edge = cut_.edges()[e];
      for (std::size_t k = 0; k < operands_; ++k) {
        const int right = behind[k] + (k == more ? 1 : 0);
        right_[edge.representative * operands_ + k] = edge.is_against ? right - times(edge.representative, k) : right;
      }
      know(edge.representative);
    };
    constexpr std::uint32_t NO_OPERAND = Cut_edge::NONE;
    tell(after[a], NO_OPERAND);
    tell(before[b], NO_OPERAND);
    tell(before[a], operand_b);
    tell(after[b], operand_a);
  }
  [[nodiscard]] int right_of(std::uint32_t e, std::size_t k) const {
    const Cut_edge& edge = cut_.edges()[e];
    return edge.is_against ? left(edge.representative, k) : right(edge.representative, k);
  }
  // The sign of the tangents' cross product, 0 where doubles do not tell.
  [[nodiscard]] int side_of_crossing(const Plain_crossing& at) const {
    Xy<double> tangent[2];
    double error[2];
    for (const int i : {0, 1}) {
      const Curve_cut& c = cut_.cuts()[i == 0 ? at.cut_a : at.cut_b];
      const Bezier_evaluator& curve = cut_.curves().evaluator(c.place.bezier);
      const Curve_jet jet = curve(c.t());
      const double first = curve.errors_at(c.t(), jet).first;
      tangent[i] = jet.first;
      error[i] = first + curve.first_change(cut_.curves().rounding(c.place.bezier), first) +
                 (c.place.t.upper - c.place.t.lower) * curve.second_bound();
    }
    const double sine = cross(tangent[0], tangent[1]);
    const double u = euclidean_norm(tangent[0]), v = euclidean_norm(tangent[1]);
    constexpr double ROUNDING = 8 * HALF_ULP;
    const double room = u * error[1] + v * error[0] + error[0] * error[1] + ROUNDING * u * v;
    return sine > room ? 1 : (sine < -room ? -1 : 0);
  }

  const Cut_curves& cut_;
  Edge_rays& rays_;
  const std::vector<std::uint32_t>& operand_;  // by curve
  std::size_t operands_;
  std::vector<int> times_, right_;          // by class and operand
  std::vector<char> is_known_;              // by class
  std::vector<std::uint32_t> next_member_;  // edges of a class
  std::vector<std::uint32_t> todo_;
  bool is_decided_ = true;
};

}  // namespace CGAL::Bounding_arcs::internal

#endif
