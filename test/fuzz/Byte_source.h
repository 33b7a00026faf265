// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any bytes as curves with hostile numbers: repeated, next to each other, in lines, huge and tiny, of any weights.
// Bytes that are used up are zeros.

#ifndef BOUNDING_ARCS_FUZZ_BYTE_SOURCE_H
#define BOUNDING_ARCS_FUZZ_BYTE_SOURCE_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace bounding_arcs_fuzz {

using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::Xy;

class Byte_source {
 public:
  Byte_source(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  [[nodiscard]] bool is_over() const { return at_ == end_; }
  unsigned byte() { return at_ == end_ ? 0 : *at_++; }
  /// One of 0 ... count - 1.
  unsigned choice(unsigned count) { return byte() % count; }

  /// Any finite number of magnitude at most 2^1000.
  double number() {
    const double x = next_number();
    last_[used_++ % last_.size()] = x;
    return x;
  }

  /// A positive number, mostly of a moderate size.
  double positive() {
    const double x = std::fabs(number());
    return x > 0 ? x : 1;
  }

  /// size 2^greatest, or one of the next count - 1 halves of it.
  double tolerance(double size, int greatest, unsigned count) {
    return std::ldexp(size, greatest - static_cast<int>(choice(count)));
  }

  /// A curve as a file could have it; what is wrong with the whole of it, its knots say, is left to those who take it.
  Curve_record curve(int most_degree) {
    Curve_record record;
    const unsigned form = byte();
    record.type = form % 4 == 0 ? Curve_record::BEZIER : Curve_record::BSPLINE;
    record.degree = 1 + static_cast<int>(choice(static_cast<unsigned>(most_degree)));
    const std::size_t degree = static_cast<std::size_t>(record.degree);
    const std::size_t count = degree + 1 + (record.type == Curve_record::BEZIER ? 0 : choice(8));
    for (std::size_t i = 0; i < count; ++i) {
      const double x = number();
      record.control_points.push_back({x, number()});
    }
    if ((form & 16) != 0) record.control_points.back() = record.control_points.front();
    if ((form & 32) != 0) {
      for (std::size_t i = 0; i < count; ++i) record.weights.push_back(positive());
      if (record.type == Curve_record::BSPLINE) record.type = Curve_record::NURBS;
    }
    record.periodic = form % 4 == 1;
    record.uniform_knots = form % 4 == 2;
    if (form % 4 == 1 || form % 4 == 3) add_knots(record, record.periodic ? count + 1 : count + degree + 1);
    return record;
  }

  /// 1 to `most` curves.
  std::vector<Curve_record> curves(unsigned most, int most_degree) {
    std::vector<Curve_record> records;
    for (unsigned i = 0, count = 1 + choice(most); i < count; ++i) records.push_back(curve(most_degree));
    return records;
  }

 private:
  double small() { return static_cast<double>(byte()) - 128; }
  double last() { return last_[choice(static_cast<unsigned>(last_.size()))]; }

  double next_number() {
    constexpr double LARGEST = 0x1p1000;
    switch (byte() % 8) {
      case 0:
        return small();
      case 1:
        return small() + small() / 256;
      case 2:
        return last();
      case 3: {
        const double x = last();
        return std::nextafter(x, byte() % 2 == 0 ? LARGEST : -LARGEST);
      }
      case 4: {
        const double x = last();
        return x + std::ldexp(small(), -40);
      }
      case 5: {
        const double x = small();
        return std::ldexp(x, 7 * static_cast<int>(small()));
      }
      case 6: {
        std::array<unsigned char, sizeof(double)> bytes{};
        for (unsigned char& b : bytes) b = static_cast<unsigned char>(byte());
        double x = 0;
        std::memcpy(&x, bytes.data(), sizeof x);
        return std::fabs(x) <= LARGEST ? x : 0;
      }
      default:
        return small() / 3;
    }
  }

  // Steps of 1, 0 or any; clamped, with degree + 1 equal knots at each end, or not.
  void add_knots(Curve_record& record, std::size_t count) {
    const bool is_clamped = !record.periodic && byte() % 4 != 0;
    const std::size_t degree = static_cast<std::size_t>(record.degree);
    double knot = 0;
    for (std::size_t i = 0; i < count; ++i) {
      record.knots.push_back(knot);
      if (is_clamped && (i < degree || i + 1 + degree >= count)) continue;
      const unsigned step = byte() % 8;
      knot += step < 5 ? 1 : (step < 7 ? 0 : positive());
    }
  }

  const std::uint8_t *at_, *end_;
  std::array<double, 8> last_{};
  std::size_t used_ = 0;
};

/// The largest extent of control points, 1 where there is none.
inline double size_of(const std::vector<Curve_record>& records) {
  const Xy<double> first = records.front().control_points.front();
  double size = 0;
  for (const Curve_record& record : records)
    for (const Xy<double>& p : record.control_points)
      size = std::max({size, std::fabs(p.x / 2 - first.x / 2), std::fabs(p.y / 2 - first.y / 2)});
  return size > 0 ? 2 * size : 1;
}

}  // namespace bounding_arcs_fuzz

#endif
