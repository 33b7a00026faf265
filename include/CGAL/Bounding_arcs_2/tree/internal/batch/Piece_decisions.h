// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Decisions of thickness for pieces of one segment.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_PIECE_DECISIONS_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_BATCH_PIECE_DECISIONS_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Piece_source.h>
#include <CGAL/Bounding_arcs_2/tree/internal/batch/Batch_function.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>

namespace CGAL::Bounding_arcs::filter {

/// What is decided of up to 64 pieces.
struct Piece_decision {
  std::uint64_t above = 0;  ///< a bit a piece, the first lowest: the thickness is above eps
  double largest = 0;       ///< upper bound of the thickness of the others
};

/// Thickness against eps for consecutive pieces of one segment: in a batch, and by the traits' functor, with more
/// digits, where that does not decide.
template <class Bound, class Spiral> class Piece_decisions {
 public:
  /// `bound` and `spiral` must outlive the object.
  Piece_decisions(const Bound& bound, const Batch_functions& functions, const Spiral& spiral)
      : bound_(bound), spiral_(spiral), curve_{spiral.local_curve()}, batch_(functions(curve_.local)) {}

  Piece_decisions(const Piece_decisions&) = delete;  // refers to itself

  /// Whether there are batches for the segment, without which nothing is to be decided here.
  [[nodiscard]] bool has_batches() const { return batch_ != nullptr; }
  [[nodiscard]] const Spiral& spiral() const { return spiral_; }
  /// \pre has_batches()
  /// \param upper room for 64 upper bounds of thickness, or null if they are not wanted, which takes less time
  [[nodiscard]] Piece_decision operator()(const Batch_pieces& pieces, double eps, double* upper,
                                          Decision_counts& counts) {
    CGAL_precondition(has_batches());
    if (upper == nullptr && !is_rough_made_ && pieces.may_be_rough()) make_rough();
    const Batch_decision d = batch_(curve_, pieces, eps, upper);
    Piece_decision result{d.above, d.largest};
    std::uint64_t open = pieces.all() & ~(d.above | d.within);
    counts.batch += pieces.count - (open == 0 ? 0 : std::bitset<BATCH_SIZE>(open).count());
    for (int i = 0; open != 0; ++i, open >>= 1) {
      if ((open & 1) == 0) continue;
      const Thickness_bound b = bound_(Piece_source<Spiral>{spiral_, pieces.begin(i), pieces.end(i)}, eps);
      if (upper != nullptr) upper[i] = b.upper;
      if (b.within) result.largest = (std::max)(result.largest, b.upper);
      else result.above |= std::uint64_t(1) << i;
      ++(b.was_exact ? counts.exact : counts.bounded);
    }
    return result;
  }

 private:
  // When it is first read: segments of few pieces do without, which saves some per cent of a build at coarse eps.
  void make_rough() {
    is_rough_made_ = true;
    if (make_rough_form(curve_.local, rough_)) curve_.rough = &rough_;
  }

  const Bound& bound_;
  const Spiral& spiral_;
  Batch_curve curve_;
  Batch_function batch_;
  Local_form<float> rough_;
  bool is_rough_made_ = false;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
