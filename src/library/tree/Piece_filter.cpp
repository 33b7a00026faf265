// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of tree/internal/Piece_filter.h.

#include "batch/Piece_decisions.h"

#include <algorithm>

namespace CGAL::Bounding_arcs::filter {

struct Piece_filter::State {
  Batch_functions functions;
  Look_ahead ahead;
  Level_strategy levels;
};

Piece_filter::Piece_filter(Method method, Build_options::Instruction_set set) : method_(method), set_(set) {
  if (set == Build_options::Instruction_set::NONE) return;
  with_formulas(method, [&](auto f) {
    state_.reset(new State{Batch_functions::of<typename decltype(f)::Type>(set), {}, {}});
  });
}
Piece_filter::~Piece_filter() = default;

void Piece_filter::look_ahead(const Spiral* first, std::size_t count, double eps, bool keeps_thickness) {
  if (state_) state_->ahead.decide(state_->functions, first, count, eps, keeps_thickness);
}

std::optional<internal::Subdivision> Piece_filter::subdivide(const Spiral& spiral, double eps, std::size_t limit,
                                                             internal::Region_nodes& nodes, Decision_counts& counts,
                                                             const Open_piece& open) {
  if (!state_) return std::nullopt;
  const Segment_top top = state_->ahead.top(spiral);
  const internal::Subdivision begun = state_->levels.begin(top, nodes, counts);
  if (state_->levels.is_done()) return internal::Subdivision{begun.bound, nodes.size() > limit};
  Piece_decisions decide(open, state_->functions, spiral.local_curve());
  if (!decide.has_batches()) return std::nullopt;
  return state_->levels.finish(decide, top, eps, limit, nodes, counts);
}

std::optional<unsigned> Piece_filter::are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                                double eps, const Open_piece& open) const {
  if (!state_) return std::nullopt;
  const Local_curve curve = spiral.local_curve();
  const Bound_function bound = state_->functions.one(curve.kind);
  if (bound == nullptr) return std::nullopt;
  const internal::Spiral_grid grid(spiral.first(), spiral.last());
  unsigned thick = 0;
  for (unsigned i = 0; i < count; ++i) {
    const double begin = grid.parameter(level, place + i), end = grid.parameter(level, place + i + 1);
    const Bracket b = bound(curve, begin, end, eps, level <= LAST_LONG_LEVEL);
    if (b.lower > eps || (!(b.upper <= eps) && !open(begin, end, eps).within)) thick |= 1U << i;
  }
  return thick;
}

bool Piece_filter::bound(const Segment_curve& segment, double eps, const std::vector<double>& breaks,
                         std::vector<double>& upper, Decision_counts& counts, const Open_piece& open) const {
  if (!state_) return false;
  Piece_decisions decide(open, state_->functions, segment);
  if (!decide.has_batches()) return false;
  constexpr std::size_t LONG = 8;  // pieces of a segment: fewer are likely to turn by too much for narrow forms
  const std::size_t count = breaks.size() - 1;
  upper.resize((count + BATCH_SIZE - 1) / BATCH_SIZE * BATCH_SIZE);
  for (std::size_t i = 0; i < count; i += BATCH_SIZE) {
    Batch_pieces pieces = Batch_pieces::between(breaks.data() + i, (std::min)(count - i, BATCH_SIZE));
    pieces.are_long = count <= LONG;
    static_cast<void>(decide(pieces, eps, upper.data() + i, counts));
  }
  upper.resize(count);
  return true;
}

}  // namespace CGAL::Bounding_arcs::filter
