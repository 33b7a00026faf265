// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Json_curve.h"

#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/number/expected.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::text_of;
using CGAL::Bounding_arcs::Xy;

namespace {

using nlohmann::json;

// Binomial coefficients up to 32 over 16 are exact in double, and no drawing program goes beyond.
constexpr int MAXIMUM_DEGREE = 32;

constexpr double MAXIMUM_UNIT = 1e30;  // mm, beyond what anything is drawn in

constexpr const char* A_DEGREE = "a whole number from 1 to 32";
constexpr const char* A_PART = "two parameters [t0, t1]";
constexpr const char* A_TYPE = R"("bezier", "bspline", "nurbs" or "path")";

double number_of(const json& value) {
  return value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

const char* wrong_number(double x) {
  if (!std::isfinite(x)) return "a finite number";
  return std::abs(x) > MAXIMUM_COORDINATE ? "a number of magnitude at most 2^1000" : nullptr;
}

const char* wrong_weight(double w) {
  if (const char* const wrong = wrong_number(w)) return wrong;
  if (!(w > 0)) return "a positive weight";
  return w > MAXIMUM_WEIGHT || w < 1 / MAXIMUM_WEIGHT ? "a weight within 2^-500 and 2^500" : nullptr;
}

const char* read_type(const json& value, Curve_record::Type& type) {
  if (value == "bezier") type = Curve_record::BEZIER;
  else if (value == "bspline") type = Curve_record::BSPLINE;
  else if (value == "nurbs") type = Curve_record::NURBS;
  else if (value == "path") type = Curve_record::PATH;
  else return A_TYPE;
  return nullptr;
}

const char* read_degree(const json& value, int& degree) {
  const double x = number_of(value);
  if (!(x >= 1 && x <= MAXIMUM_DEGREE) || x != std::floor(x)) return A_DEGREE;
  degree = static_cast<int>(x);
  return nullptr;
}

const char* read_truth(const json& value, bool& truth) {
  if (!value.is_boolean()) return "true or false";
  truth = value.get<bool>();
  return nullptr;
}

const char* read_colour(const json& value, Curve_record::Colour& colour) {
  constexpr const char* A_COLOUR = R"(a colour: a number from 1 to 255, or "#rrggbb")";
  const double x = number_of(value);
  if (x >= 1 && x <= 255 && x == std::floor(x)) {
    colour = {static_cast<int>(x), -1};
    return nullptr;
  }
  const std::string text = value.is_string() ? value.get<std::string>() : "";
  if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != text.npos)
    return A_COLOUR;
  colour = {0, static_cast<int>(std::strtol(text.c_str() + 1, nullptr, 16))};
  return nullptr;
}

const char* read_into(std::vector<double>& list, double x, const char* wrong) {
  if (wrong == nullptr) list.push_back(x);
  return wrong;
}

// Builds the curve once, so that what only the whole of it can tell is found here.
void check(Curve_record& record) {
  if (record.type == Curve_record::BEZIER || record.type == Curve_record::PATH) {
    (void)record.bezier_pieces<double>();
    return;
  }
  const auto spline = record.b_spline<double>();
  const auto first = spline.knots().begin() + record.degree;
  if (record.periodic && !record.uniform_knots)
    record.knots.assign(first, first + static_cast<std::ptrdiff_t>(record.control_points.size()) + 1);
}

}  // namespace

Json_role role_in_curve(const std::string& key) {
  static constexpr std::pair<const char*, Json_role> ROLES[] = {
      {"type", Json_role::TYPE},       {"name", Json_role::NAME},         {"degree", Json_role::DEGREE},
      {"closed", Json_role::CLOSED},   {"periodic", Json_role::PERIODIC}, {"control_points", Json_role::POINTS},
      {"weights", Json_role::WEIGHTS}, {"knots", Json_role::KNOTS},       {"pieces", Json_role::PIECES},
      {"part", Json_role::PART},       {"delta", Json_role::DELTA},       {"layer", Json_role::LAYER},
      {"colour", Json_role::COLOUR},   {"unit_in_mm", Json_role::UNIT},   {"y_is_down", Json_role::Y_IS_DOWN}};
  for (const auto& [name, role] : ROLES)
    if (key == name) return role;
  return Json_role::IGNORED;
}

Json_role role_in_piece(const std::string& key) {
  const Json_role role = role_in_curve(key);
  return role == Json_role::POINTS || role == Json_role::WEIGHTS ? role : Json_role::IGNORED;
}

// The points and weights read last are those of a piece.
const char* Json_curve::add_piece() {
  is_in_piece_ = false;
  const auto points = std::exchange(record_.control_points, {});
  const auto weights = std::exchange(record_.weights, {});
  if (points.size() < 2 || points.size() > MAXIMUM_DEGREE + 1) return "2 to 33 control points";
  if (!weights.empty() && weights.size() != points.size()) return "as many weights as control points";
  if (!record_.beziers.empty() && !(record_.beziers.back().control_points().back() == points.front()))
    return "a piece that starts where the one before ends";
  if (has_failed()) return nullptr;  // its numbers may be wrong
  record_.beziers.emplace_back(points, weights);
  record_.degree = (std::max)(record_.degree, record_.beziers.back().degree());
  return nullptr;
}

void Json_curve::begin(Json_role list) {
  given_ |= 1u << static_cast<unsigned>(list);
  coordinates_ = 0;
  if (list == Json_role::PIECE) {
    is_in_piece_ = true;
    record_.control_points.clear();
    record_.weights.clear();
  }
  has_own_points_ = has_own_points_ || (list == Json_role::POINTS && !is_in_piece_);
}

const char* Json_curve::end(Json_role list, std::size_t count) {
  if (list == Json_role::PIECE) return add_piece();
  if (list == Json_role::PART) return count == 2 ? nullptr : A_PART;
  if (list != Json_role::POINT) return nullptr;
  if (count != 2) return "a point [x, y]";
  record_.control_points.push_back({xy_[0], xy_[1]});
  return nullptr;
}

const char* Json_curve::take(Json_role role, const json& value) {
  given_ |= 1u << static_cast<unsigned>(role);
  switch (role) {
    case Json_role::TYPE:
      return read_type(value, record_.type);
    case Json_role::DEGREE:
      return read_degree(value, record_.degree);
    case Json_role::CLOSED:
      return read_truth(value, record_.closed);
    case Json_role::PERIODIC:
      return read_truth(value, record_.periodic);
    case Json_role::NAME:
      if (!value.is_string()) return "a string";
      record_.name = value.get_ref<const std::string&>();
      return nullptr;
    case Json_role::LAYER:
      if (!value.is_string()) return "a string";
      record_.layer = value.get_ref<const std::string&>();
      return nullptr;
    case Json_role::COLOUR:
      return read_colour(value, record_.colour);
    case Json_role::UNIT:
      unit_in_mm_ = value.is_null() ? 0 : number_of(value);
      return value.is_null() || (unit_in_mm_ > 0 && unit_in_mm_ < MAXIMUM_UNIT) ? nullptr : "a length above 0, or null";
    case Json_role::Y_IS_DOWN:
      return read_truth(value, record_.y_is_down);
    case Json_role::COORDINATE:
      if (coordinates_ < xy_.size()) xy_[coordinates_++] = number_of(value);
      return wrong_number(number_of(value));
    case Json_role::WEIGHT:
      return read_into(record_.weights, number_of(value), wrong_weight(number_of(value)));
    case Json_role::KNOT:
      return read_into(record_.knots, number_of(value), wrong_number(number_of(value)));
    case Json_role::PARAMETER:
      return read_into(record_.part, number_of(value), wrong_number(number_of(value)));
    case Json_role::DELTA:
      record_.delta = number_of(value);
      return record_.delta > 0 ? wrong_number(record_.delta) : "a number above 0";
    case Json_role::KNOTS:
      return (record_.uniform_knots = value == "uniform") ? nullptr : R"("uniform" or a list)";
    case Json_role::POINT:
      return "a point [x, y]";
    case Json_role::PART:
      return A_PART;
    case Json_role::CURVES:
    case Json_role::POINTS:
    case Json_role::WEIGHTS:
    case Json_role::PIECES:
      return "a list";
    case Json_role::DOCUMENT:
    case Json_role::CURVE:
    case Json_role::PIECE:
      return "an object";
    case Json_role::IGNORED:
      break;
  }
  return nullptr;
}

// What is wrong with the keys together, as a place in the curve and a reason; {"", ""} when nothing is.
Json_curve::Complaint Json_curve::complaint() const {
  const bool is_bezier = record_.type == Curve_record::BEZIER, is_nurbs = record_.type == Curve_record::NURBS;
  const auto missing = [](const char* key) {
    return Complaint{"", "expected the key \"" + std::string(key) + "\", found none"};
  };
  if (!has(Json_role::TYPE)) return missing("type");
  if (record_.type == Curve_record::PATH) {
    if (!has(Json_role::PIECES)) return missing("pieces");
    if (record_.beziers.empty()) return {"pieces", "expected at least one piece, found none"};
    if (has(Json_role::PART)) return {"part", "expected none, as only a bezier has one, found one"};
    return has_own_points_ ? Complaint{"control_points", "expected them in the pieces of the path, found them beside"}
                           : Complaint{};
  }
  if (has(Json_role::PIECES)) return {"pieces", "expected none, as only a path has them, found some"};
  if (!has(Json_role::DEGREE)) return missing("degree");
  if (!has(Json_role::POINTS)) return missing("control_points");
  if (is_nurbs && !has(Json_role::WEIGHTS)) return missing("weights");
  if (is_nurbs && record_.weights.empty()) return {"weights", "expected one a control point of a nurbs, found none"};
  if (!is_bezier && has(Json_role::PART)) return {"part", "expected none, as only a bezier has one, found one"};
  if (has(Json_role::PART) && !(record_.part[0] >= 0 && record_.part[0] < record_.part[1] && record_.part[1] <= 1))
    return {"part",
            "expected parameters 0 <= t0 < t1 <= 1, found " + text_of(Xy<double>{record_.part[0], record_.part[1]})};
  if (is_bezier && record_.periodic) return {"periodic", "expected false of a bezier, found true"};
  if (is_bezier && has(Json_role::KNOTS)) return {"knots", "expected none of a bezier, found some"};
  if (!is_bezier && !has(Json_role::KNOTS)) return missing("knots");
  if (!is_bezier && !record_.uniform_knots && record_.knots.empty())
    return {"knots", "expected at least one knot, found none"};
  const std::size_t n = record_.control_points.size(), order = static_cast<std::size_t>(record_.degree) + 1;
  if (is_bezier && n != order)
    return {"control_points", "expected " + std::to_string(order) + " of a bezier of degree " +
                                  std::to_string(record_.degree) + ", found " + std::to_string(n)};
  return {};
}

Curve_record Json_curve::finish(const std::string& file, const std::string& path, const std::string& default_name) {
  if (error_) throw Input_error(*error_);
  const std::string place = path.empty() ? "curve" : path;
  const Complaint wrong = complaint();
  if (!wrong.reason.empty())
    throw Input_error(file, wrong.key.empty() ? place : (path.empty() ? "" : path + '.') + wrong.key, wrong.reason);
  if (record_.type == Curve_record::BSPLINE && !record_.weights.empty()) record_.type = Curve_record::NURBS;
  if (!has(Json_role::NAME)) record_.name = default_name;
  try {
    check(record_);
  } catch (const std::invalid_argument& error) {
    throw Input_error(file, place, error.what());
  }
  return std::move(record_);
}

}  // namespace bounding_arcs_tool
