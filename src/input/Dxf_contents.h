// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a DXF file holds: entities of the drawing, blocks apart, and layers.

#ifndef BOUNDING_ARCS_TOOL_DXF_CONTENTS_H
#define BOUNDING_ARCS_TOOL_DXF_CONTENTS_H

#include "Dxf_digits.h"
#include "Dxf_shapes.h"

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace bounding_arcs_tool {

/// Where a block is put, in columns and rows.
struct Dxf_insertion {
  std::string block;  ///< as a key; empty for none
  Svg_transform place, scale;
  long long columns = 1, rows = 1;
  double column_step = 0, row_step = 0;

  [[nodiscard]] Svg_transform at(long long column, long long row) const {
    return place * svg_translation(static_cast<double>(column) * column_step, static_cast<double>(row) * row_step) *
           scale;
  }
};

/// A colour as it stands in an entity or layer.
struct Dxf_colour {
  static constexpr int BY_BLOCK = 0, BY_LAYER = 256;
  int number = BY_LAYER;
  int rgb = -1;  ///< of group 420; -1 for none
};

/// An entity: its curves, or an insertion, or why it is left out.
struct Dxf_entity {
  std::string kind, layer, name;  ///< a name where the file tells one
  std::size_t number = 0;         ///< of its noun, from 1
  std::vector<Dxf_curve> curves;
  double arc_size = 0;  ///< see Dxf_digits
  Dxf_insertion insertion;
  std::string reason;  ///< why it is left out, or empty
  std::string fault;   ///< what was wrong with it, though it was read, or empty
  bool is_in_paper = false, is_invisible = false;
  Dxf_colour colour;

  /// What records without a layer are called: "line", "polyline".
  [[nodiscard]] std::string noun() const;
};
struct Dxf_block {
  Xy<double> base{0, 0};
  bool is_elsewhere = false;  ///< another file has it
  std::vector<Dxf_entity> entities;
};
struct Dxf_layer {
  bool is_off = false, is_frozen = false;
  Dxf_colour colour;
};

/// Blocks and layers are found by their names as keys.
struct Dxf_contents {
  Dxf_block drawing;
  std::map<std::string, Dxf_block> blocks;
  std::map<std::string, Dxf_layer> layers;
  bool has_end = false;   ///< the file ends with EOF
  double unit_in_mm = 0;  ///< by $INSUNITS; 0 for none
  Dxf_digits digits;      ///< of the numbers of all entities
};

/// A name of a block or layer as a key: their case does not count.
[[nodiscard]] std::string dxf_key(std::string_view name);

/// \throws Input_error with the line for what is no group code
[[nodiscard]] Dxf_contents dxf_contents(std::string_view text, const std::string& file);

}  // namespace bounding_arcs_tool

#endif
