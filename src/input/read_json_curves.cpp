// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A JSON document to curve records. Places are paths into the document, such as curves[2].control_points[5][0].

#include "Curve_readers.h"
#include "Input_text.h"
#include "Json_document.h"

#include <cmath>
#include <utility>

namespace bounding_arcs_tool {

namespace {

using nlohmann::json;

// Binomial coefficients up to 32 over 16 are exact in double, and no drawing program goes beyond.
constexpr int MAXIMUM_DEGREE = 32;

std::string shown(const json& value) {
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return value.dump();
}

// A value of the document with its place, and what may be asked of it.
class Node {
 public:
  Node(const json& value, std::string place, const std::string& file)
      : value_(&value), place_(std::move(place)), file_(&file) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw Input_error(*file_, place_.empty() ? "curve" : place_, reason);
  }
  [[noreturn]] void expected(const std::string& what) const { fail("expected " + what + ", found " + shown(*value_)); }

  [[nodiscard]] bool has(const char* key) const { return value_->contains(key); }

  [[nodiscard]] Node at(const char* key) const {
    if (!has(key)) fail("the key " + in_quotes(key) + " is missing");
    return Node((*value_)[key], place_.empty() ? key : place_ + '.' + key, *file_);
  }

  [[nodiscard]] std::vector<Node> items() const {
    if (!value_->is_array()) expected("a list");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < value_->size(); ++i)
      nodes.emplace_back((*value_)[i], place_ + '[' + std::to_string(i) + ']', *file_);
    return nodes;
  }

  [[nodiscard]] double number() const {
    const double x = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!std::isfinite(x)) expected("a finite number");
    if (std::abs(x) > MAXIMUM_COORDINATE) expected("a number of magnitude at most 2^1000");
    return x;
  }

  [[nodiscard]] double weight() const {
    const double w = number();
    if (!(w > 0)) expected("a positive weight");
    if (w > MAXIMUM_WEIGHT || w < 1 / MAXIMUM_WEIGHT) expected("a weight within 2^-500 and 2^500");
    return w;
  }

  [[nodiscard]] int degree() const {
    const double x = value_->is_number() ? value_->get<double>() : std::nan("");
    if (!(x >= 1 && x <= MAXIMUM_DEGREE) || x != std::floor(x))
      expected("a whole number from 1 to " + std::to_string(MAXIMUM_DEGREE));
    return static_cast<int>(x);
  }

  [[nodiscard]] Xy<double> point() const {
    if (!value_->is_array() || value_->size() != 2) expected("a point [x, y]");
    const std::vector<Node> xy = items();
    return {xy[0].number(), xy[1].number()};
  }

  [[nodiscard]] const std::string& text() const {
    if (!value_->is_string()) expected("a string");
    return value_->get_ref<const std::string&>();
  }

  [[nodiscard]] bool truth() const {
    if (!value_->is_boolean()) expected("true or false");
    return value_->get<bool>();
  }

  [[nodiscard]] bool is_list() const { return value_->is_array(); }
  [[nodiscard]] bool is_text(const char* text) const { return *value_ == text; }

  void expect_object() const {
    if (!value_->is_object()) expected("an object");
  }

 private:
  const json* value_;
  std::string place_;
  const std::string* file_;
};

Curve_record::Type type_of(const Node& type) {
  if (type.is_text("bezier")) return Curve_record::BEZIER;
  if (type.is_text("bspline")) return Curve_record::BSPLINE;
  if (type.is_text("nurbs")) return Curve_record::NURBS;
  type.expected(R"("bezier", "bspline" or "nurbs")");
}

void read_knots(const Node& curve, Curve_record& record) {
  if (record.type == Curve_record::BEZIER) {
    if (curve.has("knots")) curve.at("knots").fail("a bezier has no knots");
    return;
  }
  const Node knots = curve.at("knots");
  record.uniform_knots = knots.is_text("uniform");
  if (record.uniform_knots) return;
  if (!knots.is_list()) knots.expected(R"("uniform" or a list)");
  for (const Node& knot : knots.items()) record.knots.push_back(knot.number());
  if (record.knots.empty()) knots.fail("expected at least one knot, found none");
}

// Builds the curve once, so that what only the whole of it can tell is found here.
void check(const Node& curve, Curve_record& record) {
  const std::size_t n = record.control_points.size(), order = static_cast<std::size_t>(record.degree) + 1;
  if (record.type == Curve_record::BEZIER && n != order)
    curve.at("control_points")
        .fail("a bezier of degree " + std::to_string(record.degree) + " has " + std::to_string(order) +
              " control points, found " + std::to_string(n));
  try {
    if (record.type == Curve_record::BEZIER) {
      (void)bezier_pieces<double>(record);
      return;
    }
    const auto spline = b_spline<double>(record);
    const auto first = spline.knots().begin() + record.degree;
    if (record.periodic && !record.uniform_knots)
      record.knots.assign(first, first + static_cast<std::ptrdiff_t>(n) + 1);
  } catch (const std::invalid_argument& error) {
    curve.fail(error.what());
  }
}

Curve_record read_curve(const Node& curve, const std::string& default_name) {
  curve.expect_object();
  Curve_record record;
  record.type = type_of(curve.at("type"));
  record.name = curve.has("name") ? curve.at("name").text() : default_name;
  record.degree = curve.at("degree").degree();
  for (const Node& point : curve.at("control_points").items()) record.control_points.push_back(point.point());
  if (record.type == Curve_record::NURBS || curve.has("weights"))
    for (const Node& weight : curve.at("weights").items()) record.weights.push_back(weight.weight());
  if (record.type == Curve_record::NURBS && record.weights.empty())
    curve.at("weights").fail("a nurbs has a weight a control point, found none");
  if (record.type == Curve_record::BSPLINE && !record.weights.empty()) record.type = Curve_record::NURBS;
  record.closed = curve.has("closed") && curve.at("closed").truth();
  record.periodic = curve.has("periodic") && curve.at("periodic").truth();
  if (record.type == Curve_record::BEZIER && record.periodic) curve.at("periodic").fail("a bezier is never periodic");
  read_knots(curve, record);
  check(curve, record);
  return record;
}

}  // namespace

std::vector<Curve_record> read_json_curves(const std::string& text, const std::string& file, const std::string& stem) {
  const json document = parsed_json(text, file);
  const Node root(document, "", file);
  if (!document.is_object()) Node(document, "document", file).expected("an object");
  if (!root.has("curves")) return {read_curve(root, stem)};
  const std::vector<Node> curves = root.at("curves").items();
  if (curves.empty()) root.at("curves").fail("expected at least one curve, found none");
  std::vector<Curve_record> records;
  for (std::size_t i = 0; i < curves.size(); ++i)
    records.push_back(read_curve(curves[i], stem + '.' + std::to_string(i + 1)));
  return records;
}

}  // namespace bounding_arcs_tool
