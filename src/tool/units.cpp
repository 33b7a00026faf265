// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "units.h"

#include "../input/Input_text.h"
#include "number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

namespace bounding_arcs_tool {

namespace ba = CGAL::Bounding_arcs;

namespace {

struct Named_unit {
  const char* word;
  double in_mm;
};
// One of CSS has 96 pixels an inch.
constexpr Named_unit UNITS[] = {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"px", 25.4 / 96}};

// Multiplies, or divides by what is more often a number of few digits.
class Scaling {
 public:
  Scaling(double from, double to) : factor_(from >= to ? from / to : to / from), divides_(from < to) {}
  [[nodiscard]] double operator()(double x) const { return divides_ ? x / factor_ : x * factor_; }
  [[nodiscard]] ba::Xy<double> operator()(const ba::Xy<double>& p) const { return {(*this)(p.x), (*this)(p.y)}; }

 private:
  double factor_;
  bool divides_;
};

void scale(std::vector<ba::Xy<double>>& points, const Scaling& scaled, const std::string& name,
           const std::string& curve) {
  constexpr double LARGEST = 0x1p1000;  // as readers have it
  for (ba::Xy<double>& p : points) {
    p = scaled(p);
    if (!(std::fabs(p.x) <= LARGEST && std::fabs(p.y) <= LARGEST))
      throw ba::Input_error(name, "curve \"" + curve + "\"",
                            "expected coordinates of magnitude at most 2^1000 in the other unit, found a larger one");
  }
}

// Has a page tell its size in a unit.
void size_page(ba::Curve_file::Page& page, double in_mm) {
  const std::string word = word_of_unit(in_mm);
  const auto size = [&](double units) {
    return word.empty() && in_mm > 0 ? number(units * in_mm) + "mm" : number(units) + word;
  };
  page.view_box = number(page.x) + " " + number(page.y) + " " + number(page.width) + " " + number(page.height);
  page.shown_width = size(page.width);
  page.shown_height = size(page.height);
  page.aspect_ratio.clear();
}

}  // namespace

ba::Curve_file::Page page_of(const CGAL::Bbox_2& box, double unit_in_mm) {
  // Boxes are widened by rounding, which is no part of a step.
  constexpr double STEPS = 1000, ROUNDING = 1e-6;
  const double extent = (std::max)(box.x_span(), box.y_span());
  const double step = extent > 0 ? std::pow(10, std::floor(std::log10(extent / STEPS))) : 1;
  const Scaling to_steps(1, step), from_steps(step, 1);
  const auto down = [&](double x) { return from_steps(std::floor(to_steps(x) + ROUNDING)); };
  const auto up = [&](double x) { return from_steps(std::ceil(to_steps(x) - ROUNDING)); };
  ba::Curve_file::Page page;
  page.x = down(box.xmin()), page.y = down(box.ymin());
  page.width = up(box.xmax() - page.x), page.height = up(box.ymax() - page.y);
  for (double* length : {&page.width, &page.height})
    if (*length == 0) *length = step;  // a line has a page, too
  size_page(page, unit_in_mm);
  return page;
}

void tell_unit(ba::Curve_file& file, double in_mm) {
  file.unit_in_mm = in_mm;
  if (file.page) size_page(*file.page, in_mm);
}

std::vector<std::string> unit_words() {
  std::vector<std::string> words;
  for (const Named_unit& unit : UNITS) words.emplace_back(unit.word);
  return words;
}

double unit_of_word(const std::string& word) {
  for (const Named_unit& unit : UNITS)
    if (word == unit.word) return unit.in_mm;
  return 0;
}

std::string word_of_unit(double in_mm) {
  for (const Named_unit& unit : UNITS)
    if (in_mm > 0 && is_same_unit(in_mm, unit.in_mm)) return unit.word;
  return "";
}

std::string unit_text(double in_mm) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.9g mm", in_mm);
  return digits;
}

std::string taken_unit_text(const File_unit& other) {
  return "no unit told: 1 unit is taken for " + unit_text(other.in_mm) + ", as in " +
         one_line(other.file, std::string::npos);
}

bool is_same_unit(double a, double b) {
  // Files write sizes with seven digits or so. A US survey foot is longer than a foot by twice as much.
  constexpr double SAME_UNIT = 1e-6;
  return std::fabs(a - b) <= SAME_UNIT * (std::max)(a, b);
}

void convert_to_unit(ba::Curve_file& file, double in_mm, const std::string& name) {
  const Scaling scaled(file.unit_in_mm, in_mm);
  for (ba::Curve_record& record : file.curves) {
    scale(record.control_points, scaled, name, record.name);
    record.end_error = scaled(record.end_error);
    for (ba::Bezier_curve_2<double>& piece : record.beziers) {
      std::vector<ba::Xy<double>> points = piece.control_points();
      scale(points, scaled, name, record.name);
      piece = ba::Bezier_curve_2<double>(std::move(points), piece.weights());
    }
  }
  file.rounding = scaled(file.rounding);
  if (file.page)
    for (double* length : {&file.page->x, &file.page->y, &file.page->width, &file.page->height})
      *length = scaled(*length);
  tell_unit(file, in_mm);
}

}  // namespace bounding_arcs_tool
