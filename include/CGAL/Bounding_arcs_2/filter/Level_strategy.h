// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The subtree of a segment many pieces at a time: level by level as tree/subdivide.h says, the pieces of a level in
// batches.  The pieces still open on a level are few runs of neighbours, as thickness varies slowly.  Levels that
// batches can answer for from below are not looked at.
//
// Why levels may be skipped.  The bits of Batch_decision::above hold for the piece and for every piece around it.  So a
// tree first looks at a low level; where all of it is above eps, no level above needs a look.  This needs that
// thickness does not grow when a piece is shortened, or at least that the lower bounds of batches are bounds for all
// pieces around.  Decisions of single pieces are not inherited (Piece_decision::inherited).  A prime marks a part of
// the piece with one end moved inward; the tight end comes first, and the curve turns left.
//
// BCA.  Thickness is (c/2)(b0 - b1), b_i = tan(alpha_i/2), e = b0 - b1 >= 0.  Moving the flat end along the curve, per
// arc length: dc/ds = cos alpha1, dalpha0/ds = sin alpha1 / c, dalpha1/ds = kappa1 - sin alpha1 / c.  Twice the
// derivative of thickness is
//   e cos alpha1 + c/2 [(1 + b0^2) sin alpha1 / c - (1 + b1^2)(kappa1 - sin alpha1 / c)]
//     = e + b1 e^2 / (1 + b1^2) + (1 + b1^2)(sin alpha1 - K1) >= 0,
// as sin alpha1 = 2 b1 / (1 + b1^2), and sin alpha1 >= K1 by Kneser's theorem.  Moving the tight end outward gives,
// with b = b0, likewise e - b e^2 / (1 + b^2) + (1 + b^2)(K0 - sin alpha0), which is not negative, as
// b e <= b^2 < 1 + b^2.
//
// Bilens.  It is the union of all spirals with the same end points, end tangents and end curvatures (Kurnosenko 2013,
// doc/papers.md).  A spiral through a part's ends with its tangents and curvatures continues with the rest of the curve
// to a spiral of the whole, so the bilens of a part lies in that of the whole.  Thickness is the diameter of the disc
// between the two contact circles on their line of centres; the disc lies in the bilens.  No disc in a bilens is wider
// than its thickness: the normal of the inner boundary, which is convex, through the disc's centre holds a diameter,
// and its part within the bilens is no longer than the thickness.  So the part's disc is no wider than the whole's
// thickness.
//
// Spiral fat arcs.  Let H be the convex hull of the tight end's circle O and the flat end.  The inner boundary is part
// of that of H.  Let R be the region, T its thickness; every point of R is within T of H.
//  * R' lies in R.  The flat end's osculating circles are nested, and the curve's tangent at a later tight end meets
//    the outer circle later.
//  * A point x of R' is no nearer to H than to H'.  Tight end moved: O lies in O', so H lies in H'.  Flat end moved:
//    O' = O, and the curve crosses the line of the inner segment of R' at the new flat end once for all, since it is
//    convex; so H lies behind that line.  For x over the segment this is the claim; for x over the arc, O touches H up
//    to a later joint than H', so the nearest point is the same.
// So R' holds no point farther than T from H'.  If the corner i' is nearest to the arc of the inner boundary, the
// corner distance is the distance of i' from H', and the height of the outer arc is never more than the distance of its
// point from H', which lies behind the segment's line: T' <= T.  Where i' is not, or may not be, lower bounds are
// lessened or not given (Spiral_fat_arc_batch.h).

#ifndef CGAL_BOUNDING_ARCS_2_FILTER_LEVEL_STRATEGY_H
#define CGAL_BOUNDING_ARCS_2_FILTER_LEVEL_STRATEGY_H

#include <CGAL/Bounding_arcs_2/filter/Piece_decisions.h>
#include <CGAL/Bounding_arcs_2/internal/tree/bits.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Bounding_arcs::filter {

/// The last level whose pieces are likely to turn by too much for narrow forms: a segment turns by some half of a right
/// angle as a rule.
inline constexpr int LAST_LONG_LEVEL = 3;

/// Pieces place, ..., place + count - 1 of a level.
/// \param are_kept whether their thickness is
[[nodiscard]] inline Batch_pieces pieces_of(const Spiral_grid& grid, int level, std::uint64_t place, std::size_t count,
                                            bool are_kept = false) {
  return {count,
          nullptr,
          nullptr,
          grid.first(),
          grid.step(level),
          grid.last(),
          static_cast<double>(place),
          level <= LAST_LONG_LEVEL,
          are_kept};
}

/// The pieces of the first three levels, level by level: one batch takes no longer than one of them would.
struct Top_pieces {
  static constexpr int LEVELS = 3;
  static constexpr std::size_t COUNT = (std::size_t(1) << LEVELS) - 1;
  double begins[COUNT], ends[COUNT];

  /// \pre grid.levels() >= LEVELS
  explicit Top_pieces(const Spiral_grid& grid) {
    for (int level = 0, i = 0; level < LEVELS; ++level)
      for (std::uint64_t k = 0; k < std::uint64_t(1) << level; ++k, ++i) {
        begins[i] = grid.parameter(level, k);
        ends[i] = grid.parameter(level, k + 1);
      }
  }
  [[nodiscard]] Batch_pieces pieces(bool are_kept) const { return {COUNT, begins, ends, 0, 0, 0, 0, true, are_kept}; }
};

class Level_strategy {
 public:
  /// Appends a segment's nodes: the same as Bounding_arcs::subdivide.
  /// \param decide Piece_decisions of the segment
  template <class Decide>
  [[nodiscard]] Subdivision subdivide(Decide& decide, double eps, std::size_t limit, internal::Region_nodes& nodes,
                                      Decision_counts& counts) {
    const Spiral_grid grid(decide.spiral().first(), decide.spiral().last());
    Work<Decide> work(decide, grid, eps, limit, nodes, counts);
    int level = start(work);
    for (; !next_.empty() && !work.is_over_limit(); ++level) {
      open_.swap(next_);
      next_.clear();
      for (const Run& run : open_) {
        if (level < run.split_below) {
          nodes.append_split(run.end - run.begin);
          open_run({2 * run.begin, 2 * run.end, run.split_below});
        } else {
          for (std::uint64_t place = run.begin; place < run.end; place += BATCH_SIZE)
            add(work, level, place, (std::min<std::size_t>)(run.end - place, BATCH_SIZE));
        }
      }
    }
    next_.clear();
    levels_before_ = level;
    return {work.bound, work.is_over_limit()};
  }

 private:
  struct Run {  // pieces begin, ..., end - 1 of a level
    std::uint64_t begin, end;
    int split_below;  // the pieces and those below them are known to be split on levels before this one
  };
  template <class Decide> struct Work {
    Work(Decide& decider, const Spiral_grid& segment, double tolerance, std::size_t most_nodes,
         internal::Region_nodes& to, Decision_counts& count)
        : decide(decider), grid(segment), eps(tolerance), limit(most_nodes), nodes(to), counts(count) {}

    Decide& decide;
    const Spiral_grid& grid;
    double eps;
    std::size_t limit;
    internal::Region_nodes& nodes;
    Decision_counts& counts;
    double bound = 0;
    bool is_hopeless = false, has_top = false;
    Piece_decision top;                // of the first levels, and
    double top_thickness[BATCH_SIZE];  // set with it
    [[nodiscard]] bool is_over_limit() const { return nodes.size() > limit || is_hopeless; }
  };

  // The first level to decide, with its runs in next_. Where the thickness of a part tells that of the whole, levels
  // can be decided before those above them, which then need no look.
  template <class Decide> [[nodiscard]] int start(Work<Decide>& work) {
    constexpr int LEVEL = 3, PIECES = 1 << LEVEL;
    next_.assign(1, {0, 1, 0});
    if (work.nodes.keeps_thickness() || work.grid.levels() <= LEVEL || levels_before_ <= LEVEL) return 0;
    double thickness[BATCH_SIZE];
    if (work.decide(pieces_of(work.grid, LEVEL, 0, PIECES), work.eps, thickness, work.counts).inherited !=
        (1 << PIECES) - 1)
      return 0;
    work.nodes.append_split(2 * PIECES - 1);
    next_.clear();
    for (int i = 0; i < PIECES; ++i) {
      // thickness falls by 8 a level, about
      const int below = (std::min)(std::ilogb(thickness[i] / work.eps), 3 * (work.grid.levels() - LEVEL - 1)) / 3;
      const auto place = static_cast<std::uint64_t>(i);
      // a level of more pieces than nodes allowed would take longer than to find out that there are too many
      const bool known = below > 1 && std::uint64_t(1) << below <= work.limit &&
                         are_above(work, LEVEL + below, place << below, std::uint64_t(1) << below);
      open_run({2 * place, 2 * place + 2, known ? LEVEL + below + 1 : 0});
    }
    return LEVEL + 1;
  }
  template <class Decide>
  [[nodiscard]] static bool are_above(Work<Decide>& work, int level, std::uint64_t place, std::uint64_t count) {
    for (std::uint64_t done = 0; done < count; done += BATCH_SIZE) {
      const Batch_pieces pieces =
          pieces_of(work.grid, level, place + done, (std::min<std::size_t>)(count - done, BATCH_SIZE));
      if (work.decide(pieces, work.eps, nullptr, work.counts).inherited != pieces.all()) return false;
    }
    return true;
  }

  template <class Decide> void add(Work<Decide>& work, int level, std::uint64_t place, std::size_t count) {
    double thickness[BATCH_SIZE];
    const bool is_last = level == work.grid.levels();
    const bool wants_thickness = work.nodes.keeps_thickness() || level == 0 || is_last;
    if (level == 0) decide_top(work);
    const Piece_decision decision = work.has_top && level < Top_pieces::LEVELS
                                        ? part_of_top(work, level, place, count, thickness)
                                        : work.decide(pieces_of(work.grid, level, place, count, wants_thickness),
                                                      work.eps, wants_thickness ? thickness : nullptr, work.counts);
    std::uint64_t above = decision.above;
    work.bound = (std::max)(work.bound, decision.largest);
    if (const double far = hopeless_thickness(work.limit, work.eps); level == 0 && thickness[0] > far)
      work.is_hopeless = work.decide(pieces_of(work.grid, 0, 0, 1), far, nullptr, work.counts).above != 0;
    if (above != 0 && is_last) {
      work.bound = (std::max)(work.bound, *std::max_element(thickness, thickness + count));
      above = 0;
    }
    work.nodes.append(thickness, above, count);
    while (above != 0) {
      const int first = internal::count_zeros(above), length = internal::count_zeros(~(above >> first));
      const std::uint64_t begin = 2 * (place + static_cast<std::uint64_t>(first));
      open_run({begin, begin + 2 * static_cast<std::uint64_t>(length), 0});
      if (first + length >= 64) break;
      above &= ~std::uint64_t(0) << (first + length);
    }
  }
  template <class Decide> static void decide_top(Work<Decide>& work) {
    work.has_top = work.grid.levels() >= Top_pieces::LEVELS;
    if (!work.has_top) return;
    const Top_pieces top(work.grid);
    work.top = work.decide(top.pieces(work.nodes.keeps_thickness()), work.eps, work.top_thickness, work.counts);
  }
  template <class Decide>
  [[nodiscard]] static Piece_decision part_of_top(const Work<Decide>& work, int level, std::uint64_t place,
                                                  std::size_t count, double* thickness) {
    const std::uint64_t begin = (std::uint64_t(1) << level) - 1 + place;
    Piece_decision part;
    part.above = work.top.above >> begin & ~(~std::uint64_t(0) << count);
    for (std::size_t i = 0; i < count; ++i) {
      thickness[i] = work.top_thickness[begin + i];
      if ((part.above >> i & 1) == 0) part.largest = (std::max)(part.largest, thickness[i]);
    }
    return part;
  }
  void open_run(const Run& run) {
    const bool joins = !next_.empty() && next_.back().end == run.begin && next_.back().split_below == run.split_below;
    if (joins) next_.back().end = run.end;
    else next_.push_back(run);
  }
  int levels_before_ = 0;  // of the segment before, which the next one is likely to be like
  std::vector<Run> open_, next_;
};

}  // namespace CGAL::Bounding_arcs::filter

#endif
