// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A search for the pieces on which figures of regions lose most digits: from the worst of some random spirals it climbs
// by steps of a few units in the last place of a coordinate, a weight or a parameter.

#ifndef CGAL_BOUNDING_ARCS_2_STUDY_WORST_CASE_HUNT_H
#define CGAL_BOUNDING_ARCS_2_STUDY_WORST_CASE_HUNT_H

#include <CGAL/Bounding_arcs_2/study/Stability_study.h>
#include <CGAL/Bounding_arcs_2/study/stability_families.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <random>
#include <vector>

namespace CGAL::Bounding_arcs {

/// A search for the largest relative error of each chosen figure in turn. Each step measures one piece, so that as many
/// steps with the same seed find the same. What it finds is a lower bound of the worst, no more.
/// \code
/// Worst_case_hunt hunt({{"bca"}, {"stable"}, {"double"}, {"thickness"}}, 7);
/// while (hunt.steps() < 1000) hunt.step();
/// const double found = hunt.worst().rows().front().rel_error;
/// \endcode
/// A formula of one's own is hunted by Formula_study::hunt.
/// \guarantee each row found is of a piece of one spiral segment, measured as by stability_rows
class Worst_case_hunt {
 public:
  /// Tells whether a choice names figures that there are: a BCA has no joints, stable formulas have no bisectors.
  [[nodiscard]] static bool has_figures(const Stability_choice& choice);
  /// \param choice the figures that are hunted; empty lists name all of them but normals and bisectors
  /// \pre has_figures(choice)
  Worst_case_hunt(const Stability_choice& choice, unsigned seed);
  /// Measures a piece in a way of one's own. The largest relative error of its rows is what a climb increases; rows of
  /// estimates do not count.
  using Measure = std::function<std::vector<Stability_row>(const Study_piece&)>;
  /// \param starts pieces that climbs start from, taken by chance; random spirals where there are none
  Worst_case_hunt(Measure measure, std::vector<Study_piece> starts, unsigned seed);

  /// Measures one more piece.
  void step();
  [[nodiscard]] std::size_t steps() const { return steps_; }
  /// The worst row of each figure so far, of family "hunt"; delta and number are the step.
  [[nodiscard]] const Worst_rows& worst() const { return worst_; }

 private:
  // A piece, and the error of the figure that is hunted.
  struct Place {
    Study_piece piece;
    double error;
  };

  void start_climb();
  [[nodiscard]] Study_piece start();
  [[nodiscard]] std::optional<Place> measured(Study_piece piece);
  [[nodiscard]] std::optional<Study_piece> neighbour(const Study_piece& piece);
  [[nodiscard]] double moved(double x);

  std::vector<Measure> figures_;
  std::size_t figure_ = 0;  // the current one
  std::mt19937 random_;
  std::vector<Study_piece> own_starts_;
  Random_spirals spirals_;
  std::optional<Place> place_;
  std::size_t steps_ = 0, starts_ = 0, since_gain_ = 0;
  Worst_rows worst_{false};
};

}  // namespace CGAL::Bounding_arcs

#endif
