// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Hierarchies and chains of arcs over decoded curves.

#include "Byte_source.h"
#include "targets.h"

#include <Hierarchy.h>

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>

namespace bounding_arcs_fuzz {
namespace {

namespace ba = CGAL::Bounding_arcs;
namespace tool = bounding_arcs_tool;

}  // namespace

void build(const std::uint8_t* data, std::size_t size) {
  Byte_source bytes(data, size);
  const auto method = static_cast<tool::Method>(bytes.choice(3));
  const auto split = static_cast<tool::Split>(bytes.choice(2));
  const bool is_certified = bytes.choice(4) == 0;
  const Curve_record record = bytes.curve(6);
  attempt([&] {
    constexpr std::size_t MOST_REGIONS = 2000, MOST_PROVEN = 20;
    const double eps = bytes.tolerance(size_of({record}), 4, 32);
    const auto segmented = tool::segment(record, tool::Kernel::DOUBLE);
    const auto hierarchy = segmented->build(method, split, eps, MOST_REGIONS, {});
    if (hierarchy->status() == tool::Status::COMPLETE) expect(hierarchy->bound() <= eps, "no leaf is too thick");
    if (hierarchy->status() == tool::Status::REGION_LIMIT) return;
    std::size_t leaves = 0;
    const auto look = [&](const tool::Output_region& region) {
      ++leaves;
      expect(region.t0 < region.t1 || segmented->number_of_spirals() > 0, "leaves are pieces");
      for (const auto* chain : {&region.inner, &region.outer})
        for (const tool::Arc_2& piece : *chain)
          expect(std::isfinite(piece.from.x + piece.to.y) && std::isfinite(piece.bulge), "ends are numbers");
    };
    if (is_certified && hierarchy->size().regions <= MOST_PROVEN) hierarchy->for_each_certified_region(look);
    else hierarchy->for_each_region(look);
    expect(leaves == hierarchy->size().regions, "all leaves are visited");
  });
}

void arcs(const std::uint8_t* data, std::size_t size) {
  Byte_source bytes(data, size);
  ba::Arc_chain::Options options;
  options.continuity = bytes.choice(2) == 0 ? ba::Arc_chain::Continuity::TANGENT : ba::Arc_chain::Continuity::POSITION;
  options.side = static_cast<ba::Arc_chain::Side>(bytes.choice(3));
  options.max_arcs = 2000;
  const auto records = bytes.curves(2, 6);
  attempt([&] {
    const double eps = bytes.tolerance(size_of(records), 4, 32);
    const ba::Arc_chain chain = ba::arc_chain(ba::Bounding_arc_tree_2(ba::drawing<double>(records)), eps, options);
    if (chain.status == ba::Build_status::COMPLETE) expect(chain.error <= eps, "no arc is farther than eps");
    if (chain.status == ba::Build_status::REGION_LIMIT) return;
    for (const ba::Arc_chain::Arc& arc : chain.arcs) {
      expect(std::isfinite(arc.from.x + arc.to.y) && std::isfinite(arc.bulge), "arcs are numbers");
      expect(arc.error <= chain.error, "the error is the largest");
    }
  });
}

}  // namespace bounding_arcs_fuzz
