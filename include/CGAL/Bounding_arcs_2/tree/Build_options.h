// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a hierarchy is told when it is built, and what it tells of that.

#ifndef CGAL_BOUNDING_ARCS_2_TREE_BUILD_OPTIONS_H
#define CGAL_BOUNDING_ARCS_2_TREE_BUILD_OPTIONS_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <cstddef>
#include <functional>

namespace CGAL::Bounding_arcs {

/// How a build ended.
enum class Build_status {
  COMPLETE,            ///< every leaf's thickness is at most eps
  RESOLUTION_REACHED,  ///< eps is below what coordinates or parameters resolve; see Region_hierarchy_2::bound
  REGION_LIMIT         ///< more region nodes than allowed would be needed; there are none
};

/// How a hierarchy of regions is built.
/// \code
/// Build_options options;
/// options.nodes = Build_options::Nodes::LAZY;
/// const Region_hierarchy_2 regions(tree, 1e-9, options);
/// \endcode
struct Build_options {
  /// Registers that loops over many pieces run in, NONE: every piece is bounded by itself. Results do not depend on it.
  /// The library has each loop for every set; the machine tells which one is called.
  enum class Instruction_set { NONE, BASE, AVX2, AVX512, BEST };

  /// Tells whether this machine has an instruction set.
  [[nodiscard]] static bool is_available(Instruction_set set) {
#ifdef __x86_64__
    __builtin_cpu_init();
    if (set == Instruction_set::AVX2) return __builtin_cpu_supports("avx2");
    if (set == Instruction_set::AVX512)
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
#endif
    return set == Instruction_set::BASE;
  }

  /// Which nodes a segment's subtree has, and whether they are kept.
  enum class Nodes {
    STORED,    ///< pieces are halved at the parameter midpoint; a node is a bit, whether it is split
    LAZY,      ///< the same nodes, made as a traversal goes below: a query that sees few of them pays for those alone
    EQUALIZED  ///< fewest leaves: a segment is cut where all its regions are about as thick as eps allows, and the
               ///< leaves are joined two by two, as evenly as their number lets
  };

  Nodes nodes = Nodes::STORED;
  std::size_t max_nodes = 20'000'000;                      ///< the most region nodes, of all segments together
  std::function<void(std::size_t, std::size_t)> progress;  ///< called with segments done and segments in all
  /// Keep each stored node's thickness as it was bounded when it was made, 8 bytes, instead of computing it
  /// again, and more sharply, when it is asked for.
  bool keep_thickness = false;
  /// Decide many pieces at a time where that serves regions and segments, else one by one. Nodes are the same.
  bool is_filtered = true;
  Instruction_set instruction_set = Instruction_set::BEST;
};

/// How many pieces were decided at which stage.
/// \code
/// const Region_hierarchy_2 regions(tree, 1e-9);
/// std::cout << regions.decisions().exact << " of " << regions.decisions().all() << " pieces were decided exactly\n";
/// \endcode
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

}  // namespace CGAL::Bounding_arcs

#endif
