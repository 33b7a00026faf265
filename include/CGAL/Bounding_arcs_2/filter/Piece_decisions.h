// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Thickness against eps for consecutive pieces of a spiral segment: in a batch where construction, number type and
// curve have one, and piece by piece with more digits where that does not decide.

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_PIECE_DECISIONS_H
#define CGAL_BOUNDING_ARCS_2_FILTER_PIECE_DECISIONS_H

#include <CGAL/Bounding_arcs_2/filter/Batch_function.h>
#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace CGAL::Bounding_arcs {

/// How many decisions were taken at which stage.
struct Decision_counts {
  std::size_t batch = 0;    ///< in batches of floats or doubles, with bounds known ahead
  std::size_t bounded = 0;  ///< double with a running error bound
  std::size_t exact = 0;    ///< intervals over exact figures, then exact numbers
  [[nodiscard]] std::size_t all() const { return batch + bounded + exact; }
  void add(const Decision_counts& other) {
    batch += other.batch;
    bounded += other.bounded;
    exact += other.exact;
  }
};

namespace filter {

/// eps, or the least thickness that the coordinates and cuts of the segment resolve where that is larger.
template <class Spiral> [[nodiscard]] double reachable(double eps, const Spiral& spiral) {
  // A thickness this many times the error of a point still means something; below it regions of neighbours overlap
  // by rounding alone. Ten times less and leaves would be of the size of the rounding itself.
  constexpr double RESOLUTION_PER_ERROR = 2;
  return (std::max)(eps, RESOLUTION_PER_ERROR * (spiral.point_error() + spiral.cut_error()));
}

}  // namespace filter

struct Piece_decision {
  std::uint64_t above = 0;      ///< a bit a piece, the first lowest: the thickness is above eps
  std::uint64_t inherited = 0;  ///< those of them whose thickness lets all pieces which contain them be above eps
  double largest = 0;           ///< upper bound of the thickness of the others
};

/// \tparam IN_DOUBLE decide as a filtered kernel does, whatever the kernel is: the same decisions where it is exact,
///   and the same upper bounds of thickness with both
template <class Traits, class Spiral, bool IN_DOUBLE = false> class Piece_decisions {
  template <class S, class = void> struct Has_batch_curve : std::false_type {};
  template <class S>
  struct Has_batch_curve<S, std::void_t<decltype(std::declval<const S&>().batch_curve())>> : std::true_type {};
  static constexpr bool HAS_BATCH =
      (IN_DOUBLE || std::is_same_v<typename Traits::FT, double>)&&Has_batch_curve<Spiral>::value &&
      !std::is_void_v<typename Traits::Construction::Batch>;

 public:
  static constexpr std::size_t MAX_PIECES = filter::BATCH_SIZE;

  Piece_decisions(const Traits& traits, Instruction_set set) : bound_(bound_of(traits)) {
    if constexpr (HAS_BATCH) functions_ = filter::Batch_functions::template of<typename Traits::Construction>(set);
  }

  /// Some decisions hold for the pieces above, too.
  static constexpr bool MAY_BE_INHERITED = HAS_BATCH || Traits::Construction::THICKNESS_IS_MONOTONE;

  /// Whether pieces of the segment are bounded in batches.
  [[nodiscard]] bool has_batch(const Spiral& spiral) const {
    if constexpr (HAS_BATCH) return functions_(spiral.batch_curve()) != nullptr;
    else return false;
  }

  /// Decides the pieces.
  /// \param upper room for 64 upper bounds of thickness, or null if they are not wanted, which takes less time
  [[nodiscard]] Piece_decision operator()(const Spiral& spiral, const filter::Batch_pieces& pieces, double eps,
                                          double* upper, Decision_counts& counts) const {
    std::uint64_t open = pieces.all();
    Piece_decision result;
    if constexpr (HAS_BATCH) {
      const filter::Batch_curve& curve = spiral.batch_curve();
      if (const auto batch = functions_(curve)) {
        const filter::Batch_decision d = batch(curve, pieces, eps, upper);
        result = {d.above, d.above, d.largest};
        open &= ~(d.above | d.within);
        counts.batch += pieces.count - (open == 0 ? 0 : std::bitset<MAX_PIECES>(open).count());
      }
    }
    for (int i = 0; open != 0; ++i, open >>= 1) {
      if ((open & 1) == 0) continue;
      const Thickness_bound b = bound_(Piece{spiral, pieces.begin(i), pieces.end(i)}, eps);
      if (upper != nullptr) upper[i] = b.upper;
      if (b.within) result.largest = (std::max)(result.largest, b.upper);
      else result.above |= std::uint64_t(1) << i;
      if (!b.within && Traits::Construction::THICKNESS_IS_MONOTONE) result.inherited |= std::uint64_t(1) << i;
      ++(b.was_exact ? counts.exact : counts.bounded);
    }
    return result;
  }

  /// An upper bound of a piece's thickness within some ulp of it, where a batch's may be 1e-9 of it above.
  /// \param is_within whether the piece was decided to be within eps: then the bound is, too
  [[nodiscard]] double thickness(const Spiral& spiral, const filter::Batch_pieces& piece, double eps,
                                 bool is_within) const {
    const double upper = bound_(Piece{spiral, piece.begin(0), piece.end(0)}, eps).upper;
    return is_within ? (std::min)(upper, eps) : upper;
  }

 private:
  struct Piece {  // a model of ChordShapeSource
    using Exact_number_type = typename Spiral::Exact_number_type;
    const Spiral& spiral;
    double t0, t1;
    template <class NT> [[nodiscard]] Chord_shape_2<NT> shape(const Shape_parts& parts) const {
      return spiral.template shape<NT>(t0, t1, parts);
    }
  };

  struct Bound_in_double {
    typename Traits::Construction construction;
    template <class ShapeSource> [[nodiscard]] Thickness_bound operator()(const ShapeSource& source, double eps) const {
      return bound_thickness<double, true>(construction, source, eps);
    }
  };

  using Bound = std::conditional_t<IN_DOUBLE, Bound_in_double, typename Traits::Bound_thickness_2>;
  [[nodiscard]] static Bound bound_of(const Traits& traits) {
    if constexpr (IN_DOUBLE) return {traits.construction()};
    else return traits.bound_thickness_2_object();
  }

  Bound bound_;
  filter::Batch_functions functions_;
};

}  // namespace CGAL::Bounding_arcs

#endif
