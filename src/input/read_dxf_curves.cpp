// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Collects the entities of a DXF file that dxflib reads, those of blocks apart, and puts blocks where they are
// inserted.

#include "Curve_readers.h"
#include "Dxf_groups.h"
#include "Dxf_shapes.h"
#include "Input_text.h"

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::B_spline_curve_2;

// Keeps what insertions make of a small file within a megabyte of stack and some hundred megabytes.
constexpr std::size_t MAXIMUM_BLOCK_NESTING = 64, MAXIMUM_ENTITIES = 1000000;

// A curve, or a block that is inserted.
struct Dxf_entity {
  std::string kind, layer;
  std::size_t number = 0;  // of its kind, from 1
  Dxf_curve curve;
  std::string block;  // of an insertion
  std::vector<Svg_transform> places;
};
struct Dxf_block {
  Xy<double> base{0, 0};
  std::vector<Dxf_entity> entities;
};

class Dxf_listener : public DL_CreationAdapter {
 public:
  explicit Dxf_listener(std::string file) : file_(std::move(file)) {}

  std::map<std::string, Dxf_block> blocks;
  Dxf_block drawing;

  void addBlock(const DL_BlockData& data) override {
    finish();
    open_ = data.name.empty() || is_space(data.name) ? &drawing : &blocks[data.name];
    if (open_ != &drawing) open_->base = {data.bpx, data.bpy};
  }
  void endBlock() override {
    finish();
    open_ = &drawing;
  }
  void endSequence() override { finish(); }

  void addLine(const DL_LineData& d) override {
    start("line");
    mirrored_ = false;  // its coordinates are the world's
    keep(polyline_curve({{{d.x1, d.y1}, 0}, {{d.x2, d.y2}, 0}}, false));
  }
  void addArc(const DL_ArcData& d) override {
    start("arc");
    keep(conic_curve({radius(d.radius), 0, 0, d.radius, d.cx, d.cy}, d.angle1, d.angle2));
  }
  void addCircle(const DL_CircleData& d) override {
    start("circle");
    keep(conic_curve({radius(d.radius), 0, 0, d.radius, d.cx, d.cy}, 0, 360));
  }
  void addEllipse(const DL_EllipseData& d) override {
    start("ellipse");
    constexpr double DEGREES = 57.295779513082320877;
    // its coordinates are the world's; seen from below it runs clockwise
    const double ratio = mirrored_ ? -d.ratio : d.ratio;
    mirrored_ = false;
    (void)radius(std::hypot(d.mx, d.my));
    (void)radius(d.ratio);
    const bool is_whole = std::fabs(std::fabs(d.angle2 - d.angle1) * DEGREES - 360) < 1e-9;
    keep(conic_curve({d.mx, d.my, -ratio * d.my, ratio * d.mx, d.cx, d.cy}, d.angle1 * DEGREES,
                     is_whole ? d.angle1 * DEGREES + 360 : d.angle2 * DEGREES));
  }
  void addPolyline(const DL_PolylineData& d) override {
    start("polyline");
    constexpr int CLOSED = 1, IN_SPACE = 8, MESH = 16, FACES = 64;
    if ((d.flags & (IN_SPACE | MESH | FACES)) != 0) fail("is in space, not in the plane");
    is_polyline_ = true;
    is_closed_ = (d.flags & CLOSED) != 0;
  }
  void addVertex(const DL_VertexData& d) override {
    if (is_polyline_) vertices_.push_back({{d.x, d.y}, d.bulge});
  }
  void addSpline(const DL_SplineData& d) override {
    start("spline");
    mirrored_ = false;
    is_spline_ = true;
    degree_ = static_cast<int>(d.degree);
    constexpr int LARGEST_DEGREE = 32;
    if (degree_ < 1 || degree_ > LARGEST_DEGREE) fail("has no degree from 1 to 32");
    if (d.nControl == 0) fail("has no control points; those through points alone are not read");
  }
  void addKnot(const DL_KnotData& d) override { knots_.push_back(d.k); }
  void addControlPoint(const DL_ControlPointData& d) override {
    points_.push_back({d.x, d.y});
    weights_.push_back(d.w);
  }
  void addInsert(const DL_InsertData& d) override {
    start("insert");
    constexpr int MOST = 1000;
    const int columns = std::max(1, d.cols), rows = std::max(1, d.rows);
    if (columns > MOST || rows > MOST) fail("is repeated more than 1000 times in a direction");
    const Svg_transform turn = svg_translation(d.ipx, d.ipy) * svg_rotation(d.angle);
    Dxf_entity insertion = entity();
    insertion.block = d.name;
    for (int i = 0; i < columns; ++i)
      for (int k = 0; k < rows; ++k)
        insertion.places.push_back(ocs() * turn * svg_translation(i * d.colSp, k * d.rowSp) * svg_scaling(d.sx, d.sy));
    open_->entities.push_back(std::move(insertion));
  }
  // What else there is has no curve, or is not read; it ends what was before.
  void addPoint(const DL_PointData&) override { finish(); }
  void addText(const DL_TextData&) override { finish(); }
  void addHatch(const DL_HatchData&) override { finish(); }

  // What is open where the file ends, or another entity begins: what dxflib calls ends of entities and sections are
  // others, too.
  void finish() {
    if (is_polyline_) keep(polyline_curve(vertices_, is_closed_));
    is_polyline_ = false;
    vertices_.clear();
    if (is_spline_) keep_spline();
    is_spline_ = false;
  }

  [[noreturn]] void fail(const std::string& reason) const { throw Input_error(file_, place(kind_, numbers_), reason); }

 private:
  static std::string place(const std::string& kind, const std::map<std::string, std::size_t>& numbers) {
    const auto found = numbers.find(kind);
    return kind + " " + std::to_string(found == numbers.end() ? 0 : found->second);
  }
  static bool is_space(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name.rfind("*model_space", 0) == 0 || name.rfind("*paper_space", 0) == 0 || name == "$model_space";
  }
  double radius(double r) const {
    if (!(r > 0)) fail("has a radius that is not above 0");
    return r;
  }

  // Begins an entity: its layer, and whether it is seen from below.
  void start(const std::string& kind) {
    finish();
    kind_ = kind;
    ++numbers_[kind];
    layer_ = getAttributes().getLayer();
    double z[3] = {0, 0, 1};
    if (const DL_Extrusion* extrusion = getExtrusion()) extrusion->getDirection(z);
    if (z[0] != 0 || z[1] != 0 || z[2] == 0) fail("is in space, not in the plane");
    mirrored_ = z[2] < 0;
  }
  [[nodiscard]] Svg_transform ocs() const { return svg_scaling(mirrored_ ? -1 : 1, 1); }
  [[nodiscard]] Dxf_entity entity() const { return {kind_, layer_, numbers_.at(kind_), {}, {}, {}}; }
  void keep(const Dxf_curve& curve) {
    if (curve.empty()) return;  // a point
    Dxf_entity e = entity();
    e.curve = placed(curve, ocs());
    open_->entities.push_back(std::move(e));
  }
  Dxf_curve placed(const Dxf_curve& curve, const Svg_transform& transform) const {
    try {
      return transformed(curve, transform);
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
  }
  void keep_spline() {
    std::vector<double> weights = std::move(weights_);
    const bool is_rational =
        std::any_of(weights.begin(), weights.end(), [&](double w) { return w != weights.front(); });
    for (const double w : weights)
      if (!(w >= 1 / MAXIMUM_WEIGHT && w <= MAXIMUM_WEIGHT)) fail("has a weight that is not above 0, or out of range");
    try {
      keep(B_spline_curve_2<double>(degree_, std::move(points_), std::move(knots_),
                                    is_rational ? std::move(weights) : std::vector<double>())
               .bezier_pieces());
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    points_.clear();
    knots_.clear();
    weights_.clear();
  }

  std::string file_, kind_, layer_;
  Dxf_block* open_ = &drawing;
  std::map<std::string, std::size_t> numbers_;
  bool mirrored_ = false, is_polyline_ = false, is_closed_ = false, is_spline_ = false;
  std::vector<Dxf_vertex> vertices_;
  int degree_ = 0;
  std::vector<double> knots_, weights_;
  std::vector<Xy<double>> points_;
};

// Makes records of entities, those of inserted blocks where they come to stand.
class Dxf_expansion {
 public:
  Dxf_expansion(const Dxf_listener& listener, std::string file) : listener_(listener), file_(std::move(file)) {}

  void visit(const Dxf_block& block, const Svg_transform& transform, const std::string& outer_layer,
             std::size_t depth) {
    for (const Dxf_entity& entity : block.entities) {
      const std::string place = entity.kind + " " + std::to_string(entity.number);
      if (++copies_ > MAXIMUM_ENTITIES)
        throw Input_error(file_, place, "there are more than " + std::to_string(MAXIMUM_ENTITIES) + " entities");
      // what is on layer 0 of a block goes to the layer of the insertion
      const std::string& layer = entity.layer == "0" && depth > 0 ? outer_layer : entity.layer;
      if (!entity.curve.empty()) add(entity, transform, layer, place);
      for (const Svg_transform& at : entity.places) insert(entity, transform * at, layer, depth, place);
    }
  }
  std::vector<Curve_record> records() && {
    for (std::size_t i = 0; i < records_.size(); ++i)
      if (numbers_[layers_[i]] > 1 && !layers_[i].empty())
        records_[i].name += "." + std::to_string(++named_[layers_[i]]);
    return std::move(records_);
  }

 private:
  void insert(const Dxf_entity& entity, const Svg_transform& transform, const std::string& layer, std::size_t depth,
              const std::string& place) {
    const auto found = listener_.blocks.find(entity.block);
    if (found == listener_.blocks.end())
      throw Input_error(file_, place, "there is no block " + in_quotes(entity.block));
    if (depth >= MAXIMUM_BLOCK_NESTING)
      throw Input_error(
          file_, place,
          "blocks are nested deeper than " + std::to_string(MAXIMUM_BLOCK_NESTING) + " levels, or contain themselves");
    if (++copies_ > MAXIMUM_ENTITIES)
      throw Input_error(file_, place, "there are more than " + std::to_string(MAXIMUM_ENTITIES) + " entities");
    visit(found->second, transform * svg_translation(-found->second.base.x, -found->second.base.y), layer, depth + 1);
  }
  void add(const Dxf_entity& entity, const Svg_transform& transform, const std::string& layer,
           const std::string& place) {
    Curve_record record;
    record.type = Curve_record::PATH;
    const bool is_named = !layer.empty() && layer != "0";
    record.name = is_named ? valid_utf8(layer) : entity.kind + std::to_string(entity.number);
    try {
      record.beziers = transformed(entity.curve, transform);
    } catch (const std::invalid_argument& error) {
      throw Input_error(file_, place, error.what());
    }
    record.closed = record.beziers.front().control_points().front() == record.beziers.back().control_points().back();
    for (const auto& bezier : record.beziers) record.degree = std::max(record.degree, bezier.degree());
    copies_ += record.beziers.size();
    layers_.push_back(is_named ? layer : "");
    ++numbers_[layers_.back()];
    records_.push_back(std::move(record));
  }

  const Dxf_listener& listener_;
  std::string file_;
  std::size_t copies_ = 0;
  std::vector<Curve_record> records_;
  std::vector<std::string> layers_;                     // of each record; empty for none
  std::map<std::string, std::size_t> numbers_, named_;  // records of a layer, and those that have their number
};

}  // namespace

Curve_file read_dxf_curves(const std::string& text, const std::string& file, const Reading_options&) {
  Dxf_listener listener(file);
  std::istringstream stream(std::string(checked_dxf(text, file)));
  DL_Dxf().in(stream, &listener);
  listener.finish();
  Dxf_expansion expansion(listener, file);
  expansion.visit(listener.drawing, {}, "", 0);
  std::vector<Curve_record> records = std::move(expansion).records();
  if (records.empty()) throw Input_error(file, "file", "no curve in the drawing");
  return {std::move(records), CGAL::Bounding_arcs::Fill_rule::EVEN_ODD, {}};
}

}  // namespace bounding_arcs_tool
