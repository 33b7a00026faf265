// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Commands.h"

#include "../input/Input_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>

#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

constexpr std::size_t LONGEST_NAME = 60;  // bytes

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// A literal, whose size the compiler knows.
template <std::size_t N> char* write(char* to, const char (&text)[N]) {
  std::memcpy(to, text, N - 1);
  return to + N - 1;
}

char* write_point(char* to, const Xy<double>& p) {
  to = write_number(write(to, "["), p.x);
  to = write_number(write(to, ","), p.y);
  return write(to, "]");
}

}  // namespace

std::vector<Loaded_curve> cut_curves(const std::string& file, std::vector<Curve_record>&& records, Kernel kernel) {
  std::vector<Loaded_curve> curves;
  for (Curve_record& record : records) {
    auto segmented = served(file, record.name, [&] { return segment(record, kernel); });
    curves.push_back({file, std::move(record), std::move(segmented)});
  }
  return curves;
}

std::vector<Loaded_curve> load_curves(const Options& options) {
  std::vector<Loaded_curve> curves;
  Reading_words reading = options.reading;
  for (const std::string& file : options.files) {
    CGAL::Bounding_arcs::Curve_file read = read_told(file, reading);
    reading.keep_unit({name_of_file(file), read.unit_in_mm});
    for (Loaded_curve& curve : cut_curves(name_of_file(file), std::move(read.curves), options.kernel))
      curves.push_back(std::move(curve));
  }
  return curves;
}

std::unique_ptr<Curve_hierarchy> build_hierarchy(const Loaded_curve& curve, Method method, double eps,
                                                 const Options& options, const Progress& progress) {
  auto hierarchy = curve.segmented->build(method, options.split, eps, options.max_regions, progress);
  const std::string place = "curve \"" + curve.record.name + "\"";
  if (hierarchy->status() == Status::RESOLUTION_REACHED)
    throw Input_error(curve.file, place,
                      "eps " + number(eps) + " is below what its coordinates and parameters resolve in the " +
                          name_of(options.kernel) + " kernel; " + short_number(hierarchy->bound()) + " was reached");
  if (hierarchy->status() == Status::REGION_LIMIT)
    throw Input_error(curve.file, place,
                      "eps " + number(eps) + " needs more than " + std::to_string(options.max_regions) + " nodes for " +
                          name_of(method) + "; raise --max-regions or eps");
  return hierarchy;
}

Progress_line::Progress_line(std::string what, Long_work long_work)
    : what_(std::move(what)), is_to_announce_(long_work == Long_work::ANNOUNCED), start_(seconds()), last_(start_) {}

void Progress_line::operator()(std::size_t done, std::size_t all) {
  constexpr double PERIOD = 0.25;  // seconds between two updates: readable, and no work that is over sooner shows any
  if (seconds() - last_ < PERIOD) return;
  last_ = seconds();
  if (is_to_announce_) announce(done, all);
  if (::isatty(STDERR_FILENO) == 0) return;
  shown_ = true;
  std::fprintf(stderr, "\r%s: %zu of %zu\033[K", what_.c_str(), done, all);
  std::fflush(stderr);
}

void Progress_line::announce(std::size_t done, std::size_t all) {
  constexpr double LONG = 3;  // seconds that have gone, and that are to come
  const double gone = last_ - start_;
  if (gone < LONG || done == 0) return;
  is_to_announce_ = false;
  const double to_come = gone * static_cast<double>(all - done) / static_cast<double>(done);
  if (to_come < LONG) return;
  std::fprintf(stderr, "%sbounding_arcs: %s: %zu of %zu after %.0f s, some %.0f s to come\n", shown_ ? "\r\033[K" : "",
               what_.c_str(), done, all, gone, to_come);
}

Progress_line::~Progress_line() {
  if (shown_) std::fprintf(stderr, "\r\033[K");
}

std::string below_resolution(double eps, double reached) {
  return "eps " + number(eps) + " is below what its coordinates and weights resolve; " + short_number(reached) +
         " was reached";
}

std::string json_string(const std::string& text) { return nlohmann::json(text).dump(); }

std::string table_name(const std::string& name) { return one_line(name, LONGEST_NAME); }

std::string piece_fields(const Arc_2& piece) {
  return number(piece.from.x) + "," + number(piece.from.y) + "," + number(piece.to.x) + "," + number(piece.to.y) + "," +
         number(piece.bulge);
}

char* Piece_text::write_end(char* to, const Xy<double>& p) {
  static_assert(sizeof p == 2 * sizeof(double));
  const auto is_this = [&](const Point_text& t) {  // bit for bit: 0 and -0 are not the same text
    return t.size > 0 && std::memcmp(&t.point, &p, sizeof p) == 0;
  };
  const auto found = std::find_if(points_.begin(), points_.end(), is_this);
  Point_text& text = found != points_.end() ? *found : points_[next_++ % points_.size()];
  if (found == points_.end()) {
    text.point = p;
    text.size = static_cast<std::size_t>(write_point(text.text.data(), p) - text.text.data());
  }
  std::memcpy(to, text.text.data(), text.text.size());  // of a fixed size
  return to + text.size;
}

void Piece_text::add_members(std::string& text, const Arc_2& piece) {
  constexpr std::size_t NUMBERS = 8, WORDS = 110;  // with what copies of fixed sizes write beyond
  char members[NUMBERS * NUMBER_ROOM + WORDS];
  char* to = piece.bulge == 0 ? write(members, "\"type\":\"segment\"") : write(members, "\"type\":\"arc\"");
  to = write_end(write(to, ",\"from\":"), piece.from);
  to = write_end(write(to, ",\"to\":"), piece.to);
  if (piece.bulge != 0) {
    to = write_number(write(to, ",\"bulge\":"), piece.bulge);
    if (const std::optional<Output_circle> circle = circle_of(piece)) {
      to = write_point(write(to, ",\"center\":"), circle->center);
      to = write_number(write(to, ",\"radius\":"), circle->radius);
    } else {
      to = write(to, ",\"center\":null,\"radius\":null");
    }
    to = piece.bulge > 0 ? write(to, ",\"orientation\":\"ccw\"") : write(to, ",\"orientation\":\"cw\"");
  }
  text.append(members, to);
}

void add_span_members(std::string& text, std::size_t bezier, double t0, double t1) {
  constexpr std::size_t NUMBERS = 3, WORDS = 20;
  char members[NUMBERS * NUMBER_ROOM + WORDS];
  char* to = write(members, "\"bezier\":");
  to = std::to_chars(to, to + NUMBER_ROOM, bezier).ptr;
  to = write_number(write(to, ",\"t\":["), t0);
  to = write_number(write(to, ","), t1);
  text.append(members, write(to, "]"));
}

}  // namespace bounding_arcs_tool
