// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A file of curves as bytes that Byte_source.h decodes, to fuzz from: those of at most three curves of few points.
// Usage: fuzz_encode FILE HEAD > seeds/TARGET-NAME, where HEAD are the bytes that come before the curves, in decimal

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using CGAL::Bounding_arcs::Curve_record;

void put(std::size_t byte) { std::putchar(static_cast<int>(byte)); }

void put_number(double x) {
  constexpr int AS_IT_IS = 6;
  std::array<unsigned char, sizeof x> bytes{};
  std::memcpy(bytes.data(), &x, sizeof x);
  put(AS_IT_IS);
  for (const unsigned char b : bytes) put(b);
}

void put_knots(const Curve_record& record) {
  const std::size_t count = record.knots.size(), degree = static_cast<std::size_t>(record.degree);
  const bool is_clamped = !record.periodic && record.knots[degree] == record.knots.front();
  if (!record.periodic) put(is_clamped ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (is_clamped && (i < degree || i + 1 + degree >= count)) continue;
    const double step = i + 1 < count ? record.knots[i + 1] - record.knots[i] : 1;
    put(step == 1 ? 0 : (step == 0 ? 5 : 7));
    if (step != 0 && step != 1) put_number(step);
  }
}

void put_curve(const Curve_record& record) {
  const bool is_bezier = record.type == Curve_record::BEZIER;
  const std::size_t degree = static_cast<std::size_t>(record.degree);
  put((is_bezier ? 0 : (record.uniform_knots ? 2 : (record.periodic ? 1 : 3))) + (record.weights.empty() ? 0 : 32));
  put(degree - 1);
  if (!is_bezier) put(record.control_points.size() - degree - 1);
  for (const auto& p : record.control_points) {
    put_number(p.x);
    put_number(p.y);
  }
  for (const double w : record.weights) put_number(w);
  if (!is_bezier && !record.uniform_knots) put_knots(record);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) return 2;
  for (int i = 2; i < count; ++i) put(static_cast<std::size_t>(std::atoi(arguments[i])));
  const auto records = CGAL::Bounding_arcs::read_curve_file(arguments[1]).curves;
  put(records.size() - 1);
  for (const Curve_record& record : records) put_curve(record);
}
