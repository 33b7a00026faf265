// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers on a page of a report: a drawing in units of a thousandth of its extent, y downwards, with as many decimals
// as its thinnest region needs.

#ifndef BOUNDING_ARCS_TOOL_REPORT_PAGE_SCALE_H
#define BOUNDING_ARCS_TOOL_REPORT_PAGE_SCALE_H

#include "../svg_paths.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace bounding_arcs_tool {

/// x with that many decimals and no zeros at its end, as JSON; null where it is no number.
[[nodiscard]] inline std::string decimal(double x, int decimals) {
  if (!std::isfinite(x)) return "null";
  char text[400];
  std::snprintf(text, sizeof text, "%.*f", decimals, x);
  std::string result(text);
  if (result.find('.') != std::string::npos) {
    result.erase(result.find_last_not_of('0') + 1);
    if (result.back() == '.') result.pop_back();
  }
  return result == "-0" ? "0" : result;
}

class Page_scale {
 public:
  static constexpr double EXTENT = 1000;

  /// \param eps the least thickness to be seen, in units of the coordinates
  Page_scale(const Box& box, bool flips, double eps) {
    const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
    const double scale = extent > EXTENT / std::numeric_limits<double>::max() ? EXTENT / extent : 1;
    view_ = {box.x0, flips ? box.y1 : box.y0, scale, flips};
    constexpr double OF_EPS = 3;  // decimals: a thousandth of eps is no more than a pixel where eps fills the screen
    constexpr int LEAST = 2, MOST = 12;  // what doubles have of numbers up to 1000
    decimals_ = std::clamp(static_cast<int>(std::ceil(OF_EPS - std::log10(eps * scale))), LEAST, MOST);
  }

  [[nodiscard]] double scale() const { return view_.scale; }
  [[nodiscard]] std::string point(const Xy<double>& p) const {
    const Xy<double> q = view_.place(p);
    return decimal(q.x, decimals_) + "," + decimal(q.y, decimals_);
  }
  /// The bulge as it is with y downwards, exact enough to tell the height of the arc as well as its ends.
  [[nodiscard]] std::string bulge(const Arc_2& piece) const {
    const double chord = std::hypot(piece.to.x - piece.from.x, piece.to.y - piece.from.y) * view_.scale;
    constexpr int MOST = 17;
    const int more = chord > 0 ? static_cast<int>(std::ceil(std::log10(chord))) : -MOST;
    return decimal(view_.flips ? -piece.bulge : piece.bulge, std::clamp(decimals_ + more, 0, MOST));
  }

 private:
  View view_{};
  int decimals_ = 0;
};

}  // namespace bounding_arcs_tool

#endif
