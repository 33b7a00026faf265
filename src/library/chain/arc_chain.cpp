// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of chain/arc_chain.h.

#include "../arc/Arc_text.h"
#include "Cubic_arcs.h"
#include "Spiral_arcs.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include <CGAL/Bounding_arcs_2/curve/served_range.h>
#include <CGAL/Bounding_arcs_2/number/expected.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/tree_spirals.h>
#include "../tree/equalize_breaks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

// Chains over many segments.

// Spiral_arcs for what nearly all curves consist of, in a fraction of the time: two-sided arcs over a polynomial
// segment of degree up to 3 without a cusp.

namespace CGAL::Bounding_arcs::internal {

/// Fits arcs as Spiral_arcs does, but in columns, pieces of several segments at once.
class Cubic_spiral_arcs {
 public:
  [[nodiscard]] static bool is_for(const Bezier_spiral_2<double>& spiral, Arc_chain::Side side) {
    const int degree = spiral.curve().degree();
    const End_orders orders = spiral.orders(spiral.first(), spiral.last());
    return side == Arc_chain::Side::BOTH && (degree == 2 || degree == 3) && !spiral.curve().is_rational() &&
           !spiral.is_straight() && orders.start == 1 && orders.end == 1;
  }

  /// Fits arcs as Spiral_arcs does. \pre is_for(spiral, Arc_chain::Side::BOTH)
  Cubic_spiral_arcs(const Bezier_spiral_2<double>& spiral, Arc_chain::Continuity continuity, double eps,
                    const std::optional<Xy<double>>& start)
      : spiral_(spiral), continuity_(continuity), eps_asked_(eps), unit_(spiral.table<double>().unit()),
        inverse_unit_(1 / unit_), curve_(cubic(spiral)), start_(start ? *start : spiral.point(spiral.first())),
        end_(spiral.point(spiral.last())), slack_(fitting_slack(spiral, curve_.reach(1))),
        eps_((std::max)(eps, ABOVE_ROUNDING * slack_)) {}

  [[nodiscard]] double reachable() const { return eps_; }
  [[nodiscard]] const Xy<double>& end_point() const { return end_; }

  /// Break points near those of equal errors, from the slope of curvature at about as many places as there will be
  /// pieces.
  void guess(Measured_breaks& result) const {
    constexpr std::size_t FEWEST = 4, MOST = 64;
    double sum = share_pieces(FEWEST, result);
    if (sum > FEWEST) sum = share_pieces(static_cast<std::size_t>((std::min)(sum, static_cast<double>(MOST))), result);
    constexpr double RESOLVED =
        1e6;  // more pieces than double coordinates can tell from fewer: a place is beside a cusp
    if (sum > 1 && sum < RESOLVED) redistribute(result, static_cast<std::size_t>(std::ceil(sum)));
    else result.breaks.assign({0, 1});
  }

  /// Appends pieces to columns. \pre there is room
  void add(const double* breaks, std::size_t count, Arc_columns& c) const {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t j = c.count++;
      c.x1[j] = curve_.x1;
      c.y1[j] = curve_.y1;
      c.x2[j] = curve_.x2;
      c.y2[j] = curve_.y2;
      c.x3[j] = curve_.x3;
      c.y3[j] = curve_.y3;
      c.start_x[j] = start_.x;
      c.start_y[j] = start_.y;
      c.end_x[j] = end_.x;
      c.end_y[j] = end_.y;
      c.unit[j] = unit_;
      c.inverse_unit[j] = inverse_unit_;
      c.limit[j] = eps_ * inverse_unit_;
      c.s0[j] = breaks[i];
      c.s1[j] = breaks[i + 1];
    }
  }

  /// Appends the arcs that columns hold of pieces from `first` on, and sets the error of each piece.
  void take(const Arc_columns& c, std::size_t first, std::size_t count, double* errors,
            std::vector<Arc_chain::Arc>& arcs) const {
    for (std::size_t j = first; j < first + count; ++j) {
      const double t0 = parameter(c.s0[j]), t1 = parameter(c.s1[j]);
      const Xy<double> from{c.from_x[j], c.from_y[j]}, to{c.to_x[j], c.to_y[j]};
      const double error0 = slack_ + unit_ * c.distance0[j];
      double& error = errors[j - first];
      if (continuity_ == Arc_chain::Continuity::POSITION) {
        error = error0;
        if (std::isfinite(error)) arcs.push_back({{from, to, c.bulge0[j]}, t0, t1, error, 0});
      } else {
        const double error1 = slack_ + unit_ * c.distance1[j], t = parameter(c.joint[j]);
        const Xy<double> joint{c.joint_x[j], c.joint_y[j]};
        const Arc_chain::Arc arc0{{from, joint, c.bulge0[j]}, t0, t, error0, 0},
            arc1{{joint, to, c.bulge1[j]}, t, t1, error1, 0};
        error = (std::max)(error0, error1);
        if (is_worth_balancing(error0, error1, eps_)) {
          error = in_general().fit_balanced(end_at(c.s0[j], from), end_at(c.s1[j], to), arc0, arc1, arcs);
        } else if (std::isfinite(error)) {
          arcs.push_back(arc0);
          arcs.push_back(arc1);
        }
      }
      if (!std::isfinite(error)) error = in_general().fit(end_at(c.s0[j], from), end_at(c.s1[j], to), arcs);
    }
  }

 private:
  [[nodiscard]] static Cubic cubic(const Bezier_spiral_2<double>& spiral) {
    const Taylor_table<double>& table = spiral.table<double>();
    if (table.degree() == 2) {
      const auto c = table.expand_polynomial<2>(spiral.first(), spiral.last());
      return {c[1].x, c[1].y, c[2].x, c[2].y, 0, 0};
    }
    const auto c = table.expand_polynomial<3>(spiral.first(), spiral.last());
    return {c[1].x, c[1].y, c[2].x, c[2].y, c[3].x, c[3].y};
  }

  // Sets breaks at equal distances and roots to the shares of least numbers between them, see slope_integral; their
  // sum.
  double share_pieces(std::size_t places, Measured_breaks& result) const {
    constexpr double LEAST = 1e-3;  // keeps the shares positive
    const double step = 1 / static_cast<double>(places);
    const double of_cubic = continuity_ == Arc_chain::Continuity::TANGENT ? cubic_factor::BIARC : cubic_factor::ARC;
    const double factor = step * rough_cube_root(of_cubic * unit_ / eps_);
    result.breaks.resize(places + 1);
    result.roots.resize(places);
    double sum = 0;
    for (std::size_t i = 0; i < places; ++i) {
      const Cubic q = curve_.from((static_cast<double>(i) + 0.5) * step);
      const Plane_vector c1 = q.c1(), c2 = q.c2();
      const double square = dot(c1, c1), change = 6 * cross(c1, q.c3()) * square - 12 * cross(c1, c2) * dot(c1, c2);
      result.breaks[i] = static_cast<double>(i) * step;
      result.roots[i] = factor * rough_cube_root(std::fabs(change) / (square * std::sqrt(square))) + LEAST * step;
      sum += result.roots[i];
    }
    result.breaks.back() = 1;
    return sum;
  }

  // What few pieces need, so that it may begin from the spiral again.
  [[nodiscard]] Spiral_arcs in_general() const {
    return {spiral_, continuity_, Arc_chain::Side::BOTH, eps_asked_, start_};
  }

  [[nodiscard]] double parameter(double s) const {
    return s == 1 ? spiral_.last() : spiral_.first() + s * (spiral_.last() - spiral_.first());
  }
  [[nodiscard]] Curve_end end_at(double s, const Xy<double>& point) const {
    const Plane_vector tangent = curve_.from(s).c1();
    return {s, point, {tangent.x, tangent.y}};
  }

  const Bezier_spiral_2<double>& spiral_;
  Arc_chain::Continuity continuity_;
  double eps_asked_;
  double unit_, inverse_unit_;  // a power of two
  Cubic curve_;
  Xy<double> start_, end_;
  double slack_, eps_;
};

}  // namespace CGAL::Bounding_arcs::internal

namespace CGAL::Bounding_arcs {

std::ostream& operator<<(std::ostream& out, const Arc_chain& chain) {
  Arc_text text(out);
  for (const Arc_2& arc : chain.arcs) text << arc;
  return out;
}

/// Makes the chain of many spiral segments. Most segments need few arcs, so that pieces of several are fitted at once.
class Chain_builder {
 public:
  /// \param spirals how many there will be
  Chain_builder(double eps, const Arc_chain::Options& options, std::size_t spirals)
      : eps_(eps), options_(options), expected_(spirals),
        fit_columns_(
            internal::arc_function(options.continuity == Arc_chain::Continuity::TANGENT, options.instruction_set)) {
    constexpr std::size_t ARCS =
        8;  // a segment has more than that only where eps is small; pages never touched cost nothing
    chain_.arcs.reserve(ARCS * spirals);
  }

  /// The next spiral segment in curve order; it has to outlive the builder.
  /// \throws std::invalid_argument for a curve out of the range of queries
  void add(const Bezier_spiral_2<double>& spiral) {
    if (chain_.status == Build_status::REGION_LIMIT) return;
    const bool goes_on =
        before_ != nullptr && &spiral.curve() == &before_->curve() && spiral.first() == before_->last();
    const std::optional<Xy<double>> start = goes_on ? std::optional<Xy<double>>(end_) : std::nullopt;
    if (!goes_on) internal::check_queried(spiral.curve());
    before_ = &spiral;
    if (internal::Cubic_spiral_arcs::is_for(spiral, options_.side)) {
      add_to_group(internal::Cubic_spiral_arcs(spiral, options_.continuity, eps_, start));
    } else {
      fit_group();
      const Spiral_arcs fitter(spiral, options_.continuity, options_.side, eps_, start);
      end_ = fitter.end_point();
      pieces_.breaks.assign({0, 1});
      equalize(fitter, [&](const std::vector<double>& breaks, std::vector<double>& errors) {
        fitter.fit(breaks, errors, chain_.arcs);
      });
    }
  }

  [[nodiscard]] Arc_chain finish() {
    fit_group();
    const bool are_too_many = chain_.status == Build_status::REGION_LIMIT || chain_.arcs.size() > options_.max_arcs;
    if (are_too_many) return {{}, 0, Build_status::REGION_LIMIT};
    return std::move(chain_);
  }

 private:
  // A spiral segment whose first guess waits in the columns.
  struct Member {
    internal::Cubic_spiral_arcs fitter;
    std::size_t first, count;  // of the pieces; in columns where they are at most as many as those hold
  };

  void add_to_group(const internal::Cubic_spiral_arcs& fitter) {
    end_ = fitter.end_point();
    fitter.guess(guess_);
    const std::size_t count = guess_.breaks.size() - 1;
    if (columns_.count + count > internal::Arc_columns::SIZE) fit_group();
    group_.push_back({fitter, columns_.count, count});
    group_breaks_.insert(group_breaks_.end(), guess_.breaks.begin(), guess_.breaks.end());
    if (count > internal::Arc_columns::SIZE) fit_group();
    else fitter.add(guess_.breaks.data(), count, columns_);
  }

  void fit_group() {
    if (columns_.count > 0) fit_columns_(columns_);
    std::size_t at = 0;
    for (const Member& m : group_) {
      const double* breaks = group_breaks_.data() + at;
      pieces_.breaks.assign(breaks, breaks + m.count + 1);
      at += m.count + 1;
      bool is_fitted = m.count <= internal::Arc_columns::SIZE;
      equalize(m.fitter, [&](const std::vector<double>& b, std::vector<double>& errors) {
        if (is_fitted) m.fitter.take(columns_, m.first, m.count, errors.data(), chain_.arcs);
        else fit(m.fitter, b, errors);
        is_fitted = false;
      });
    }
    group_.clear();
    group_breaks_.clear();
    columns_.count = 0;
  }

  void fit(const internal::Cubic_spiral_arcs& fitter, const std::vector<double>& breaks, std::vector<double>& errors) {
    for (std::size_t i = 0; i < errors.size(); i += internal::Arc_columns::SIZE) {
      const std::size_t count = (std::min)(errors.size() - i, internal::Arc_columns::SIZE);
      own_columns_.count = 0;
      fitter.add(breaks.data() + i, count, own_columns_);
      fit_columns_(own_columns_);
      fitter.take(own_columns_, 0, count, errors.data() + i, chain_.arcs);
    }
  }

  // Appends the arcs of the next spiral segment, from the breaks in pieces_.
  template <class Fitter, class Fit> void equalize(const Fitter& fitter, const Fit& fit) {
    if (chain_.status == Build_status::REGION_LIMIT) return;
    const std::size_t first = chain_.arcs.size();
    make_room(2 * (pieces_.breaks.size() - 1));
    const auto fit_anew = [&](const std::vector<double>& breaks, std::vector<double>& errors) {
      chain_.arcs.resize(first);
      fit(breaks, errors);
    };
    const bool within = equalize_breaks(pieces_, fitter.reachable(), options_.max_arcs, fit_anew);
    if (!within || fitter.reachable() > eps_) chain_.status = Build_status::RESOLUTION_REACHED;
    if (pieces_.is_limit_far || pieces_.breaks.size() > options_.max_arcs) chain_.status = Build_status::REGION_LIMIT;
    for (std::size_t j = first; j < chain_.arcs.size(); ++j) {
      chain_.arcs[j].spiral = spirals_;
      chain_.error = (std::max)(chain_.error, chain_.arcs[j].error);
    }
    ++spirals_;
  }

  // Instead of doubling, which touches several times the memory: for all segments as much as for those so far.
  void make_room(std::size_t arcs) {
    const std::size_t needed = chain_.arcs.size() + arcs;
    if (needed <= chain_.arcs.capacity()) return;
    constexpr double SPARE = 1.1;
    const double all = static_cast<double>(needed) / static_cast<double>(spirals_ + 1) * static_cast<double>(expected_);
    chain_.arcs.reserve(static_cast<std::size_t>(SPARE * (std::max)(all, static_cast<double>(needed))));
  }

  double eps_;
  Arc_chain::Options options_;
  std::size_t expected_;  // spiral segments
  internal::Arc_function fit_columns_;
  Arc_chain chain_;
  std::size_t spirals_ = 0;  // whose arcs are in the chain
  const Bezier_spiral_2<double>* before_ = nullptr;
  Xy<double> end_;  // of that
  Measured_breaks pieces_, guess_;
  std::vector<Member> group_;
  std::vector<double> group_breaks_;
  internal::Arc_columns columns_{}, own_columns_{};
};

Arc_chain arc_chain(const Bounding_arc_tree_2& tree, double eps, const Arc_chain::Options& options) {
  return arc_chain(spiral_segments(tree), eps, options);
}

Arc_chain arc_chain(const std::vector<Bezier_spiral_2<double>>& spirals, double eps,
                    const Arc_chain::Options& options) {
  check_above_zero("eps", eps);
  Chain_builder builder(eps, options, spirals.size());
  for (const Bezier_spiral_2<double>& spiral : spirals) builder.add(spiral);
  return builder.finish();
}

}  // namespace CGAL::Bounding_arcs
