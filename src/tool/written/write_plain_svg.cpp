// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_plain_svg.h"

#include "../number_text.h"
#include "../svg_paths.h"
#include "../units.h"
#include "colour_numbers.h"

#include <CGAL/Bbox_2.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

using Bezier = ba::Bezier_curve_2<double>;

// The weight of the middle control point when those of the ends are 1.
double middle_weight(const Bezier& conic) { return conic.weight(1) / std::sqrt(conic.weight(0) * conic.weight(2)); }

// What bulges leave of a radius has one digit less than a double.
double rounded_radius(double radius) {
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", radius);
  return std::strtod(text, nullptr);
}

// The way of pieces as the data of a path.
class Path_data {
 public:
  /// \param steps of a unit that numbers are rounded to; 0 where all digits count
  explicit Path_data(bool y_is_down, double steps = 0) : y_is_down_(y_is_down), steps_(steps) {}

  void add(const Written_piece* first, const Written_piece* last) {
    text_ += (text_.empty() ? "M" : " M") + point(start_of(*first));
    const bool is_closed = start_of(*first) == end_of(last[-1]);
    for (const Written_piece* piece = first; piece != last; ++piece)
      if (const auto* arc = std::get_if<Arc_2>(piece); arc == nullptr) add(std::get<Bezier>(*piece));
      else if (!is_closed || piece + 1 != last || arc->bulge != 0 || first + 1 == last) add(*arc);
    if (is_closed) text_ += " Z";
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  [[nodiscard]] std::string point(const Xy<double>& p) const {
    return shown(0 + p.x) + " " + shown(y_is_down_ ? 0 + p.y : 0 - p.y);  // no -0
  }
  [[nodiscard]] std::string shown(double x) const {
    return number(steps_ > 0 ? std::round(x * steps_) / steps_ + 0 : x);
  }

  void add(const Arc_2& arc) {
    // A flatter arc is the parabola with its tangents within 1e-18 of its chord, and is drawn well by viewers that
    // compute in single precision.
    constexpr double FLATTEST = 1e-6;
    // A radius with its ends loses digits of an arc that is nearly half a circle: half of them where it is one.
    constexpr double ROUNDEST = 0.99;
    const double b = std::fabs(arc.bulge);
    if (b == 0) {
      text_ += " L" + point(arc.to);
    } else if (b < FLATTEST) {
      text_ += " Q" + point(0.5 * (arc.from + arc.to) - arc.bulge * perp(arc.to - arc.from)) + " " + point(arc.to);
    } else if (b > ROUNDEST && b < 1) {
      const double bulge = std::tan(std::atan(arc.bulge) / 2);
      const Xy<double> middle_point = middle(arc);
      add({arc.from, middle_point, bulge});
      add({middle_point, arc.to, bulge});
    } else {
      const double half = std::hypot(arc.to.x - arc.from.x, arc.to.y - arc.from.y) / 2;
      double radius = rounded_radius(half * (1 + b * b) / (2 * b));
      // Readers widen a circle that does not reach the ends, so that half a circle comes out as one.
      while (b == 1 && std::hypot((arc.to.x - arc.from.x) / 2 / radius, (arc.to.y - arc.from.y) / 2 / radius) < 1)
        radius = std::nextafter(radius, 0);
      add_arc(radius, radius, 0, arc.bulge > 0, arc.to);
    }
  }

  // In the plane of the drawing counterclockwise is SVG's sweep 1 where y is downwards.
  void add_arc(double rx, double ry, double degrees, bool is_ccw, const Xy<double>& to) {
    text_ += " A" + shown(rx) + " " + shown(ry) + " " + number(y_is_down_ ? 0 + degrees : 0 - degrees) + " 0 " +
             (is_ccw == y_is_down_ ? "1 " : "0 ") + point(to);
  }

  void add(const Bezier& curve) {
    const auto& p = curve.control_points();
    if (curve.is_rational()) return add_ellipse(curve);
    text_ += curve.degree() == 2 ? " Q" : " C";
    for (std::size_t i = 1; i < p.size(); ++i) text_ += (i > 1 ? " " : "") + point(p[i]);
  }

  // A circle's arc of less than a half, with its ends at -h and h and w = cos h, in an affine image: its middle control
  // point is the image of (1/w, 0), the middle of the chord that of (w, 0), so that center and conjugate half diameters
  // are known. The axes are those of the matrix of these.
  void add_ellipse(const Bezier& conic) {
    const auto& p = conic.control_points();
    const double w = middle_weight(conic), sine = std::sqrt((1 - w) * (1 + w));
    const Xy<double> u = (w / (sine * sine)) * (p[1] - 0.5 * (p[0] + p[2])), v = (0.5 / sine) * (p[2] - p[0]);
    const double e = (u.x + v.y) / 2, f = (u.x - v.y) / 2, g = (u.y + v.x) / 2, h = (u.y - v.x) / 2;
    const double q = std::hypot(e, h), r = std::hypot(f, g);
    constexpr double DEGREES = 57.295779513082320877;
    const double turn = r == 0 ? 0 : (std::atan2(g, f) + std::atan2(h, e)) / 2 * DEGREES;
    add_arc(rounded_radius(q + r), rounded_radius(std::fabs(q - r)), turn, cross(u, v) > 0, p[2]);
  }

  bool y_is_down_;
  double steps_;
  std::string text_;
};

CGAL::Bbox_2 box_of(const Written_drawing& drawing) {
  CGAL::Bbox_2 box;
  const auto add = [&](const Xy<double>& p) {
    const double y = drawing.y_is_down ? p.y : 0 - p.y;
    box += CGAL::Bbox_2(p.x, y, p.x, y);
  };
  for (const Written_curve& curve : drawing.curves)
    for (const Written_piece& piece : curve.pieces)
      if (const auto* arc = std::get_if<Arc_2>(&piece)) {
        const CGAL::Bbox_2 of_arc = ba::box(*arc);
        add({of_arc.xmin(), of_arc.ymin()}), add({of_arc.xmax(), of_arc.ymax()});
      } else {
        for (const Xy<double>& p : std::get<Bezier>(piece).control_points()) add(p);
      }
  return drawing.curves.empty() ? CGAL::Bbox_2(0, 0, 1, 1) : box;
}

std::string colour_text(const ba::Curve_record::Colour& colour) {
  const int rgb = colour.rgb >= 0 ? colour.rgb : colour.number > 0 ? rgb_of_colour_number(colour.number) : 0;
  char text[16];
  std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(rgb));
  return text;
}

void write_attribute(std::ostream& out, const char* name, const std::string& value) {
  if (!value.empty()) out << ' ' << name << "=\"" << escaped(value) << '"';
}

// Names that have not been there.
class Unique_names {
 public:
  std::string operator()(const std::string& name) {
    if (name.empty()) return "";
    std::string unique = name;
    for (std::size_t& count = count_[name]; !taken_.insert(unique).second;)
      unique = name + "_" + std::to_string(++count + 1);
    return unique;
  }

 private:
  std::map<std::string, std::size_t> count_;
  std::set<std::string> taken_;
};

// Curves by layers, in the order of the first of each.
std::vector<std::pair<std::string, std::vector<const Written_curve*>>> by_layer(const Written_drawing& drawing) {
  std::vector<std::pair<std::string, std::vector<const Written_curve*>>> layers;
  std::map<std::string, std::size_t> number;
  for (const Written_curve& curve : drawing.curves) {
    const auto [place, is_new] = number.try_emplace(curve.look.layer, layers.size());
    if (is_new) layers.push_back({curve.look.layer, {}});
    layers[place->second].second.push_back(&curve);
  }
  return layers;
}

}  // namespace

bool is_of_svg(const Written_piece& piece) {
  constexpr int LARGEST_DEGREE = 3;
  const auto* const curve = std::get_if<Bezier>(&piece);
  if (curve == nullptr) return true;
  if (!curve->is_rational()) return curve->degree() <= LARGEST_DEGREE;
  constexpr double FLATTEST = 0x1p-29;  // flatter ones are parabolas, but for rounding; of others few digits are left
  return curve->degree() == 2 && middle_weight(*curve) < 1 - FLATTEST;
}

std::string curve_path(const View& view, const Bezier& curve) {
  constexpr int SAMPLES = 64;
  constexpr double STEPS = 1e9;  // of a pixel: twelve digits of a picture that is a thousand pixels wide
  std::vector<Xy<double>> places;
  for (const Xy<double>& p : curve.control_points()) places.push_back(view.place(p));
  std::vector<Written_piece> pieces{written_piece(Bezier(std::move(places), curve.weights()))};
  if (!is_of_svg(pieces.front())) {
    pieces.clear();
    for (int i = 0; i < SAMPLES; ++i)
      pieces.emplace_back(
          Arc_2{view.place(curve.point(i / double(SAMPLES))), view.place(curve.point((i + 1) / double(SAMPLES))), 0});
  }
  Path_data data(true, STEPS);
  data.add(pieces.data(), pieces.data() + pieces.size());
  return data.text();
}

void write_plain_svg(std::ostream& out, const Written_drawing& drawing) {
  const ba::Curve_file::Page page = drawing.page ? *drawing.page : page_of(box_of(drawing), drawing.unit_in_mm);
  out << "<svg " << SVG_NAMESPACES;
  write_attribute(out, "width", page.shown_width);
  write_attribute(out, "height", page.shown_height);
  write_attribute(out, "viewBox", page.view_box);
  write_attribute(out, "preserveAspectRatio", page.aspect_ratio);
  constexpr double STROKE = 1e-3;  // of the page
  out << ">\n<g fill=\"none\" stroke-width=\"" << short_number(STROKE * (std::max)(page.width, page.height)) << "\">\n";
  Unique_names layer_id, id;
  for (const auto& [layer, curves] : by_layer(drawing)) {
    if (!layer.empty()) {
      out << "<g inkscape:groupmode=\"layer\"";
      write_attribute(out, "inkscape:label", layer);
      out << ">\n";
    }
    for (const Written_curve* curve : curves) {
      Path_data data(drawing.y_is_down);
      for_each_run(curve->pieces, [&](const auto* first, const auto* last) { data.add(first, last); });
      out << "<path";
      write_attribute(out, "id", id(curve->name));
      out << " stroke=\"" << colour_text(curve->look.colour) << "\" d=\"" << data.text() << "\"/>\n";
    }
    if (!layer.empty()) out << "</g>\n";
  }
  out << "</g>\n</svg>\n";
}

}  // namespace bounding_arcs_tool
