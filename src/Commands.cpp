// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Commands.h"

#include "input/Input_text.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <iostream>

#include <unistd.h>

namespace bounding_arcs_tool {
namespace {

constexpr std::size_t LONGEST_NAME = 60;  // bytes

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void add_point(std::string& text, const char* key, const Xy<double>& p) {
  text += key;
  text += '[';
  add_number(text, p.x);
  text += ',';
  add_number(text, p.y);
  text += ']';
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
  for (const std::string& file : options.files)
    for (Loaded_curve& curve : cut_curves(file == "-" ? "stdin" : file, read_curves(file), options.kernel))
      curves.push_back(std::move(curve));
  return curves;
}

std::unique_ptr<Curve_hierarchy> build_hierarchy(const Loaded_curve& curve, Method method, double eps,
                                                 const Options& options, const Progress& progress) {
  auto hierarchy = curve.segmented->build(method, options.split, eps, options.max_regions, progress);
  const std::string place = "curve \"" + curve.record.name + "\"";
  char text[200];
  if (hierarchy->status() == Status::RESOLUTION_REACHED) {
    std::snprintf(text, sizeof text,
                  "eps %g is below what its coordinates and parameters resolve in the %s kernel; %.2g was reached", eps,
                  name_of(options.kernel), hierarchy->bound());
    throw Input_error(curve.file, place, text);
  }
  if (hierarchy->status() == Status::REGION_LIMIT) {
    std::snprintf(text, sizeof text, "eps %g needs more than %zu nodes for %s; raise --max-regions or eps", eps,
                  options.max_regions, name_of(method));
    throw Input_error(curve.file, place, text);
  }
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

std::string number(double x) {
  std::string text;
  add_number(text, x);
  return text;
}

void add_number(std::string& text, double x) {
  constexpr std::size_t LONGEST = 32;
  constexpr int DIGITS = 17;  // read back as the same double
  char digits[LONGEST];
  text.append(digits, std::to_chars(digits, digits + LONGEST, x, std::chars_format::general, DIGITS).ptr);
}

std::string json_string(const std::string& text) { return nlohmann::json(text).dump(); }

std::string table_name(const std::string& name) { return one_line(name, LONGEST_NAME); }

std::string piece_fields(const Output_piece& piece) {
  return number(piece.from.x) + "," + number(piece.from.y) + "," + number(piece.to.x) + "," + number(piece.to.y) + "," +
         number(piece.bulge);
}

void add_piece_members(std::string& text, const Output_piece& piece) {
  const std::optional<Output_circle> circle = circle_of(piece);
  text += piece.bulge == 0 ? "\"type\":\"segment\"" : "\"type\":\"arc\"";
  add_point(text, ",\"from\":", piece.from);
  add_point(text, ",\"to\":", piece.to);
  if (piece.bulge == 0) return;
  text += ",\"bulge\":";
  add_number(text, piece.bulge);
  if (circle) {
    add_point(text, ",\"center\":", circle->center);
    text += ",\"radius\":";
    add_number(text, circle->radius);
  } else {
    text += ",\"center\":null,\"radius\":null";
  }
  text += piece.bulge > 0 ? ",\"orientation\":\"ccw\"" : ",\"orientation\":\"cw\"";
}

}  // namespace bounding_arcs_tool
