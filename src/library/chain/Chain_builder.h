// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains over many segments.

#ifndef BOUNDING_ARCS_LIBRARY_CHAIN_CHAIN_BUILDER_H
#define BOUNDING_ARCS_LIBRARY_CHAIN_CHAIN_BUILDER_H

#include <CGAL/Bounding_arcs_2/chain/Arc_chain_2.h>
#include <CGAL/Bounding_arcs_2/curve/queried_range.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/equalize_breaks.h>
#include "Arc_columns.h"
#include "Cubic_spiral_arcs.h"
#include "Spiral_arcs.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// Makes the chain of many spiral segments. Most segments need few arcs, so that pieces of several are fitted at once.
class Chain_builder {
 public:
  /// \param spirals how many there will be
  Chain_builder(double eps, const Arc_chain_options& options, std::size_t spirals)
      : eps_(eps), options_(options), expected_(spirals),
        fit_columns_(internal::arc_function(options.continuity == Continuity::TANGENT, options.instruction_set)) {
    constexpr std::size_t ARCS =
        8;  // a segment has more than that only where eps is small; pages never touched cost nothing
    chain_.arcs.reserve(ARCS * spirals);
  }

  /// The next spiral segment in curve order; it has to outlive the builder.
  /// \throws std::invalid_argument for a curve out of the range of check_queried
  void add(const Bezier_spiral_2<double>& spiral) {
    if (chain_.status == Build_status::REGION_LIMIT) return;
    const bool goes_on =
        before_ != nullptr && &spiral.curve() == &before_->curve() && spiral.first() == before_->last();
    const std::optional<Xy<double>> start = goes_on ? std::optional<Xy<double>>(end_) : std::nullopt;
    if (!goes_on) check_queried(spiral.curve());
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
  Arc_chain_options options_;
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

}  // namespace CGAL::Bounding_arcs

#endif
