// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The filter as hierarchies call it: whether pieces of segments over doubles are thin enough, many at a time, and the
// arcs of their regions. What is in src/library/tree/batch does it, compiled once.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_PIECE_FILTER_H
#define CGAL_BOUNDING_ARCS_2_TREE_INTERNAL_PIECE_FILTER_H

#include <CGAL/Bounding_arcs_2/region/thickness_bound.h>
#include <CGAL/Bounding_arcs_2/spiral/Bezier_spiral_2.h>
#include <CGAL/Bounding_arcs_2/tree/Build_options.h>
#include <CGAL/Bounding_arcs_2/tree/Region_nodes.h>
#include <CGAL/Bounding_arcs_2/tree/subdivide.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

struct Bca;
struct Bilens;
struct Spiral_fat_arc;
namespace internal {
template <class Construction> struct With_algebraic_boundary;
}  // namespace internal

namespace filter {

/// Constructions that there are batches for.
enum class Method { NONE, BCA, BILENS, SPIRAL_FAT_ARC };
template <class Construction> inline constexpr Method METHOD = Method::NONE;
#ifndef BOUNDING_ARCS_WITHOUT_FILTER
template <> inline constexpr Method METHOD<Bca> = Method::BCA;
template <> inline constexpr Method METHOD<Bilens> = Method::BILENS;
template <> inline constexpr Method METHOD<Spiral_fat_arc> = Method::SPIRAL_FAT_ARC;
template <class Construction>
inline constexpr Method METHOD<internal::With_algebraic_boundary<Construction>> = METHOD<Construction>;
#endif

/// Whether segments keep a local curve.
template <class Spiral, class = void> inline constexpr bool has_local_curve_v = false;
template <class Spiral>
inline constexpr bool has_local_curve_v<Spiral, std::void_t<decltype(std::declval<const Spiral&>().local_curve())>> =
    true;

/// Bounds the piece [begin, end] of a segment against eps: the traits' functor, for what a batch leaves open.
using Open_piece = std::function<Thickness_bound(double begin, double end, double eps)>;

/// Decides pieces of segments. A copy is for another thread.
class Piece_filter {
  using Spiral = Bezier_spiral_2<double>;

 public:
  /// \param set NONE leaves all pieces to others, as a method without batches does
  Piece_filter(Method method, Build_options::Instruction_set set);
  Piece_filter(const Piece_filter& other) : Piece_filter(other.method_, other.set_) {}
  Piece_filter& operator=(const Piece_filter&) = delete;
  ~Piece_filter();

  /// Tells which segments subdivide is called for next: what is to be decided of them together.
  void look_ahead(const Spiral* first, std::size_t count, double eps, bool keeps_thickness);
  /// Appends the subtree of a segment, the nodes of Bounding_arcs::subdivide. \return nothing, and no nodes, where
  /// there are no batches
  [[nodiscard]] std::optional<internal::Subdivision> subdivide(const Spiral& spiral, double eps, std::size_t limit,
                                                               internal::Region_nodes& nodes, Decision_counts& counts,
                                                               const Open_piece& open);
  /// Whether pieces place and, for `count` 2, place + 1 of a level are thicker than eps, a bit each; or nothing.
  [[nodiscard]] std::optional<unsigned> are_thick(const Spiral& spiral, int level, std::uint64_t place, unsigned count,
                                                  double eps, const Open_piece& open) const;
  /// Sets upper bounds of the thickness of pieces between breaks. \return whether there are batches
  [[nodiscard]] bool bound(const Segment_curve& segment, double eps, const std::vector<double>& breaks,
                           std::vector<double>& upper, Decision_counts& counts, const Open_piece& open) const;

 private:
  struct State;
  Method method_;
  Build_options::Instruction_set set_;
  std::unique_ptr<State> state_;  // where there are batches
};

}  // namespace filter
}  // namespace CGAL::Bounding_arcs

#endif
