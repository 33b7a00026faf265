// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies of read_axis.h.

#include "read_axis.h"

#include "../../input/Input_text.h"

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <nlohmann/json.hpp>

#include <cstdint>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

// A value with where it is in its file.
class Axis_value {
 public:
  Axis_value(const nlohmann::json& value, const std::string& file, std::string place)
      : value_(value), file_(file), place_(std::move(place)) {}

  [[noreturn]] void refuse(const std::string& reason) const {
    throw ba::Input_error(file_, place_.empty() ? "document" : place_, reason);
  }
  [[nodiscard]] bool has(const char* key) const { return value_.is_object() && value_.contains(key); }
  [[nodiscard]] Axis_value operator[](const char* key) const {
    const std::string place = (place_.empty() ? "" : place_ + ".") + key;
    if (!has(key)) Axis_value(value_, file_, place).refuse("expected a value, found none");
    return {value_.at(key), file_, place};
  }
  [[nodiscard]] Axis_value operator[](std::size_t i) const {
    return {value_.at(i), file_, place_ + "[" + std::to_string(i) + "]"};
  }
  [[nodiscard]] std::size_t size() const {
    if (!value_.is_array()) refuse("expected a list, found " + kind());
    return value_.size();
  }
  [[nodiscard]] Axis_value of_size(std::size_t count) const {
    if (size() != count) refuse("expected " + std::to_string(count) + " values, found " + std::to_string(size()));
    return *this;
  }
  [[nodiscard]] double number() const {
    if (!value_.is_number()) refuse("expected a number, found " + kind());
    return value_.get<double>();
  }
  template <class Integer> [[nodiscard]] Integer index() const {
    if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > UINT32_MAX)
      refuse("expected an index from 0, found " + kind());
    return static_cast<Integer>(value_.get<std::uint64_t>());
  }
  [[nodiscard]] bool is(const char* text) const { return value_.is_string() && value_.get<std::string>() == text; }

 private:
  // What the value is: "an object", or "7".
  [[nodiscard]] std::string kind() const {
    if (value_.is_object()) return "an object";
    return value_.is_array() ? "a list of " + std::to_string(value_.size()) : value_.dump();
  }

  const nlohmann::json& value_;
  const std::string& file_;
  std::string place_;
};

ba::Curve_place place_of(const Axis_value& curve, const Axis_value& bezier, const Axis_value& t) {
  using Index = decltype(ba::Curve_place::curve);
  return {curve.index<Index>(), bezier.index<Index>(), t.number()};
}

ba::Medial_axis_2::Vertex vertex_of(const Axis_value& v) {
  ba::Medial_axis_2::Vertex vertex;
  const Axis_value point = v["point"].of_size(2), touches = v["touches"];
  vertex.center = {point[std::size_t(0)].number(), point[1].number()};
  vertex.radius = v["radius"].number();
  for (std::size_t i = 0; i < touches.size(); ++i)
    vertex.touches.push_back(place_of(touches[i]["curve"], touches[i]["bezier"], touches[i]["t"]));
  return vertex;
}

ba::Medial_axis_2::Edge edge_of(const Axis_value& e) {
  ba::Medial_axis_2::Edge edge;
  edge.from = e["from"].index<std::size_t>(), edge.to = e["to"].index<std::size_t>();
  const Axis_value line = e["polyline"];
  if (!e.has("feet")) e.refuse("expected feet, as --feet writes them, found none");
  const Axis_value feet = e["feet"].of_size(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Axis_value disc = line[i].of_size(3), both = feet[i].of_size(2);
    const Axis_value left = both[std::size_t(0)].of_size(3), right = both[1].of_size(3);
    edge.samples.push_back({{disc[std::size_t(0)].number(), disc[1].number()},
                            disc[2].number(),
                            place_of(left[std::size_t(0)], left[1], left[2]),
                            place_of(right[std::size_t(0)], right[1], right[2])});
  }
  return edge;
}

}  // namespace

Written_axis read_axis(const std::string& path) {
  const std::string file = path == "-" ? "stdin" : path, text = file_contents(path);
  const nlohmann::json document = nlohmann::json::parse(text, nullptr, false);
  const Axis_value all(document, file, "");
  if (document.is_discarded()) all.refuse("expected JSON, found other text");
  Written_axis result;
  result.is_framed = all.has("frame");
  result.axis.eps = all["eps"].number(), result.axis.error = all["error"].number();
  if (all.has("moved")) result.axis.moved = all["moved"].number();
  result.axis.regions = all["regions"].index<std::size_t>(), result.axis.holes = all["holes"].index<std::size_t>();
  if (all.has("rule")) {
    const bool is_even_odd = all["rule"].is("evenodd");
    if (!is_even_odd && !all["rule"].is("nonzero"))
      all["rule"].refuse("expected nonzero or evenodd, found another rule");
    result.rule = is_even_odd ? ba::Fill_rule::EVEN_ODD : ba::Fill_rule::NONZERO;
  }
  const Axis_value vertices = all["vertices"], edges = all["edges"];
  for (std::size_t i = 0; i < vertices.size(); ++i) result.axis.vertices.push_back(vertex_of(vertices[i]));
  for (std::size_t i = 0; i < edges.size(); ++i) result.axis.edges.push_back(edge_of(edges[i]));
  if (all.has("proof"))
    for (std::size_t i = 0; i < edges.size(); ++i)
      result.bounds.push_back(edges[i].has("bound") ? edges[i]["bound"].number() : result.axis.eps);
  return result;
}

}  // namespace bounding_arcs_tool
