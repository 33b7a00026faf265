// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any number of records for streams, from the outlines in drawings again and again, each time of another size and at
// another place, so that no two lines are the same.
// Usage: glyph_records NUMBER SCALE FILE...
//   SCALE  to the sizes that are wanted, which then vary by a quarter
//
// A record is a drawing, {"id":...,"curves":[...]}, of an outline's runs of pieces of one degree: B-splines whose inner
// knots are there as often as the degree. Coordinates have six digits, as drawing programs write them.

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace ba = CGAL::Bounding_arcs;

struct Run {
  int degree;
  std::vector<ba::Xy<double>> points;
};
using Outline = std::vector<Run>;

Outline outline(const ba::Curve_record& record) {
  Outline runs;
  for (const auto& piece : record.bezier_pieces<double>()) {
    if (piece.is_rational())
      throw std::invalid_argument(record.name + " has weights, which outlines of glyphs have not");
    const auto& points = piece.control_points();
    if (runs.empty() || runs.back().degree != piece.degree()) runs.push_back({piece.degree(), {points.front()}});
    runs.back().points.insert(runs.back().points.end(), points.begin() + 1, points.end());
  }
  return runs;
}

/// Where an outline goes: its start to (x, y), its size by a factor.
struct Placement {
  double x, y, factor;
};

void add_run(std::string& text, const Run& run, const ba::Xy<double>& start, const Placement& place) {
  char number[64];
  text += "{\"type\":\"bspline\",\"degree\":" + std::to_string(run.degree) + ",\"control_points\":[";
  for (const auto& p : run.points) {
    const ba::Xy<double> q{place.x + place.factor * (p.x - start.x), place.y + place.factor * (p.y - start.y)};
    std::snprintf(number, sizeof number, "%s[%.6g,%.6g]", &p == run.points.data() ? "" : ",", q.x, q.y);
    text += number;
  }
  text += "],\"knots\":[0";
  const std::size_t degree = static_cast<std::size_t>(run.degree), pieces = (run.points.size() - 1) / degree;
  for (std::size_t knot = 0; knot <= pieces; ++knot)
    for (std::size_t i = 0; i < degree; ++i) text += "," + std::to_string(knot);
  text += "," + std::to_string(pieces) + "]}";
}

std::string line(std::size_t id, const Outline& runs, const Placement& place) {
  std::string text = "{\"id\":" + std::to_string(id) + ",\"curves\":[";
  for (const Run& run : runs) {
    if (&run != runs.data()) text += ',';
    add_run(text, run, runs.front().points.front(), place);
  }
  return text + "]}\n";
}

void write_records(std::size_t number, double scale, const std::vector<Outline>& outlines) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> position(-1000, 1000), factor(0.8 * scale, 1.25 * scale);
  for (std::size_t id = 0; id < number; ++id) {
    const Placement place{position(random), position(random), factor(random)};
    const std::string text = line(id, outlines[id % outlines.size()], place);
    if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) throw std::runtime_error("cannot write");
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 4) throw std::invalid_argument("usage: glyph_records NUMBER SCALE FILE...");
    std::vector<Outline> outlines;
    for (int i = 3; i < argc; ++i)
      for (const ba::Curve_record& record : ba::read_curve_file(argv[i]).curves) outlines.push_back(outline(record));
    write_records(std::stoull(argv[1]), std::stod(argv[2]), outlines);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "glyph_records: %s\n", error.what());
    return 1;
  }
}
