// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Queries, offsets and medial axes of decoded curves.

#include "Byte_source.h"
#include "targets.h"

#include <CGAL/Bounding_arcs_2/medial_axis/medial_axis.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/query/convex_hull.h>
#include <CGAL/Bounding_arcs_2/query/intersections.h>
#include <CGAL/Bounding_arcs_2/query/point_location.h>

namespace bounding_arcs_fuzz {
namespace {

namespace ba = CGAL::Bounding_arcs;

// Curves that most answers are there for: all closed.
ba::Drawing_2<double> closed_drawing(Byte_source& bytes, double& size) {
  std::vector<Curve_record> records = bytes.curves(3, 4);
  size = size_of(records);
  ba::Drawing_2<double> drawing;
  for (const Curve_record& record : records) {
    auto chain = record.bezier_pieces<double>();
    const Xy<double> first = chain.front().control_points().front(), last = chain.back().control_points().back();
    if (first != last) chain.emplace_back(std::vector<Xy<double>>{last, first});
    drawing.add(std::move(chain));
  }
  return drawing;
}

void expect_bracket(const ba::Bracket& bounds) {
  expect(0 <= bounds.lower && bounds.lower <= bounds.upper, "a bracket has an order");
}

}  // namespace

void query(const std::uint8_t* data, std::size_t size) {
  Byte_source bytes(data, size);
  const auto decisions = bytes.choice(2) == 0 ? ba::Decisions::EXACT : ba::Decisions::DOUBLE;
  const double x = bytes.number();
  const Xy<double> q{x, bytes.number()};
  attempt([&] {
    double extent = 0;
    const ba::Bounding_arc_tree_2 index(closed_drawing(bytes, extent), decisions);
    const auto closest = ba::closest_point(index, q);
    if (closest) expect_bracket(closest->distance);
    expect(closest.has_value() || index.empty(), "curves have a closest point");
    const ba::Winding_number winding = ba::winding_number(index, q);
    if (decisions == ba::Decisions::EXACT)
      expect(winding.state != ba::Winding_number::State::UNDECIDED, "exact answers are decided");
    for (const auto& piece : ba::convex_hull(index, bytes.tolerance(extent, -4, 12)).pieces)
      expect(std::isfinite(piece.from_point.x() + piece.to_point.y()), "ends are numbers");
    for (const auto& common : ba::self_intersections(index).points) {
      expect(common.a.t.lower <= common.a.t.upper && common.b.t.lower <= common.b.t.upper, "a range has an order");
      expect(decisions == ba::Decisions::DOUBLE || common.kind != ba::Intersection_kind::UNDECIDED,
             "exact answers are decided");
    }
  });
}

void offset(const std::uint8_t* data, std::size_t size) {
  Byte_source bytes(data, size);
  ba::Offset::Options options;
  options.join = static_cast<ba::Offset::Join>(bytes.choice(3));
  options.cap = static_cast<ba::Offset::Cap>(bytes.choice(3));
  options.side = static_cast<ba::Offset::Side>(bytes.choice(3));
  options.rule = static_cast<ba::Fill_rule>(bytes.choice(2));
  const double part = (static_cast<double>(bytes.byte()) - 128) / 256;
  attempt([&] {
    double extent = 0;
    ba::Drawing_2<double> drawing;
    if (bytes.choice(2) == 0) {
      drawing = closed_drawing(bytes, extent);
    } else {
      const auto records = bytes.curves(3, 4);
      extent = size_of(records);
      drawing = ba::drawing<double>(records);
    }
    const double eps = bytes.tolerance(extent, -4, 12);
    const ba::Offset found = ba::offset(ba::Bounding_arc_tree_2(drawing), part * extent, eps, options);
    if (found.status == ba::Offset::Status::COMPLETE) expect(found.error <= eps, "no point is too far");
    for (const ba::Offset::Chain& chain : found.chains) {
      expect(!chain.pieces.empty(), "a chain has a piece");
      for (std::size_t i = 0; i + 1 < chain.pieces.size(); ++i)
        expect(chain.pieces[i].arc.to == chain.pieces[i + 1].arc.from, "pieces follow each other");
      if (chain.is_closed) expect(chain.pieces.back().arc.to == chain.pieces.front().arc.from, "a chain is closed");
    }
  });
}

void medial_axis(const std::uint8_t* data, std::size_t size) {
  Byte_source bytes(data, size);
  ba::Medial_axis_2::Options options;
  options.rule = static_cast<ba::Fill_rule>(bytes.choice(2));
  attempt([&] {
    double extent = 0;
    const ba::Bounding_arc_tree_2 index(closed_drawing(bytes, extent));
    const ba::Medial_axis_2 axis = ba::medial_axis(index, bytes.tolerance(extent, -4, 12), options);
    if (axis.status != ba::Medial_axis_2::Status::COMPLETE) return;
    for (const ba::Medial_axis_2::Vertex& vertex : axis.vertices)
      expect(std::isfinite(vertex.center.x + vertex.center.y) && vertex.radius >= 0, "a disc has a radius");
    for (const ba::Medial_axis_2::Edge& edge : axis.edges)
      expect(edge.from < axis.vertices.size() && edge.to < axis.vertices.size(), "an edge has ends");
  });
}

}  // namespace bounding_arcs_fuzz
