// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The area between offsets and those that Clipper makes of fine polylines: of all that belongs to one region and not to
// the other.  An offset within eps has at most eps times the length of the boundary, and what Clipper's errs by, too.
// Usage: offset_areas EPS SHARE FILE...
//   EPS    of the size of a drawing, the longer side of its control points' box
//   SHARE  of eps that Clipper's polylines may err by
//
// Distances are +-0.01, +-0.05 and +-0.2 of the size. Prints the area over eps times the length, which is the longer of
// both boundaries, and the same that may be. Returns 1 if any is more.

#include "Polygon_offset.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>
#include <CGAL/Bounding_arcs_2/offset/Offset_source_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

namespace {

using namespace bounding_arcs_benchmark;
using ClipperLib::Path;
using ClipperLib::Paths;

// Chords of an arc: one of n parts is at most 1.25 / n^2 of the arc's height from it, as sin(x / n) <= x / n and
// x <= 1.06 sin x up to a quarter of a circle's eighth, and heights are as sin^2.
void add_chords(const ba::Arc_2& arc, double error, const Clipper_grid& grid, Path& loop) {
  const double height = std::fabs(arc.bulge) / 2 * ba::euclidean_norm(arc.to - arc.from);
  const double count = (std::max)(1.0, std::ceil(std::sqrt(1.25 * height / error)));
  for (double k = 0; k < count; ++k) loop.push_back(grid(ba::point(arc, k / count)));
}

Polygon_regions regions_of(const ba::Offset& offset, const ba::Drawing_2<double>& drawing, double error,
                           const Clipper_grid& grid) {
  Polygon_regions regions;
  for (const auto& chain : offset.chains) {
    Path loop;
    for (const auto& piece : chain.pieces) add_chords(piece.arc, error, grid, loop);
    const auto& curve = drawing.curves()[chain.pieces.front().source.curve];
    (offset.distance > 0 || curve.is_closed ? regions.of_closed : regions.of_open).push_back(std::move(loop));
  }
  return regions;
}

double area_between(const Paths& a, const Paths& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(a, ClipperLib::ptSubject, true);
  clipper.AddPaths(b, ClipperLib::ptClip, true);
  Paths result;
  clipper.Execute(ClipperLib::ctXor, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return area_of(result);
}

struct Verdict {
  double share = 0;  ///< of eps times the length
  bool is_good = true;
};

Verdict compare(const std::string& file, const ba::Drawing_2<double>& drawing, double eps, double share) {
  constexpr double LARGEST = 0.2, ROOM = 0.25, OF_CHORDS = 1.0 / 16, THIN = 1.0 / 16;
  const double size = [&] {
    const Clipper_grid bare = clipper_grid(drawing, 0);
    return 2 * bare.unit * 0x1p30;
  }();
  eps *= size;
  const Clipper_grid grid = clipper_grid(drawing, ROOM * size);
  const ba::Offset_source_2 source(ba::Bounding_arc_tree_2(drawing), eps);
  Polygon_offset theirs(drawing, grid, ba::Fill_rule::NONZERO, share * eps, THIN * eps);
  Verdict worst;
  for (const double d : {0.01, -0.01, 0.05, -0.05, LARGEST, -LARGEST}) {
    const std::clock_t start = std::clock();
    const ba::Offset offset = source.at(d * size);
    const Polygon_regions a = regions_of(offset, drawing, OF_CHORDS * eps, grid), b = theirs.at(d * size);
    const double area = area_between(a.of_closed, b.of_closed) + area_between(a.of_open, b.of_open);
    const double length =
        (std::max)(length_of(a.of_closed) + length_of(a.of_open), length_of(b.of_closed) + length_of(b.of_open));
    const double at_most = 1 + OF_CHORDS + theirs.error() / eps,
                 is = length > 0 ? area * grid.unit / (length * eps) : 0;
    const bool is_good = is <= at_most && offset.status == ba::Offset::Status::COMPLETE;
    std::printf("%s: %s distance %g, %zu chains: %.3f of at most %.3f (%.1f s)\n", is_good ? "good" : "BAD",
                file.c_str(), d, offset.chains.size(), is, at_most, double(std::clock() - start) / CLOCKS_PER_SEC);
    std::fflush(stdout);
    worst = {(std::max)(worst.share, is), worst.is_good && is_good};
  }
  return worst;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fputs("usage: offset_areas EPS SHARE FILE...\n", stderr), 2;
  Verdict worst;
  for (int i = 3; i < argc; ++i) {
    const Verdict v = compare(argv[i], ba::drawing<double>(ba::read_curve_file(argv[i]).curves), std::atof(argv[1]),
                              std::atof(argv[2]));
    worst = {(std::max)(worst.share, v.share), worst.is_good && v.is_good};
  }
  std::printf("%d files, eps %s of the size: at most %.3f of eps times the length, %s\n", argc - 3, argv[1],
              worst.share, worst.is_good ? "all good" : "SOME ARE BAD");
  return worst.is_good ? 0 : 1;
}
