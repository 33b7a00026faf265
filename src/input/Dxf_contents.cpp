// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_contents.h"

#include "Dxf_groups.h"
#include "Dxf_units.h"
#include "Input_text.h"
#include "dxf_entity_curves.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bounding_arcs_tool {
namespace {

constexpr std::size_t LONGEST_KIND = 40;  // bytes that messages have of one

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

// Variables of the header have their name in a group 9, and their value in the next one.
double header_unit(const Dxf_item& header) {
  for (std::size_t i = 0; i + 1 < header.groups.size(); ++i) {
    if (header.groups[i].code != 9 || header.groups[i].value != "$INSUNITS") continue;
    try {
      return dxf_unit_in_mm(integer_value(header.groups[i + 1]));
    } catch (const Dxf_left_out&) {
      return 0;  // what is no number tells no unit
    }
  }
  return 0;
}

// What is no number has no meaning: that of a layer hides nothing, that of a colour is none.
long long integer_or(const Dxf_item& item, int code, long long otherwise) {
  try {
    return item.integer(code, otherwise);
  } catch (const Dxf_left_out&) {
    return otherwise;
  }
}

// A layer that is off has a number below 0.
Dxf_colour colour_of(const Dxf_item& item) {
  constexpr long long WHITE = 0xFFFFFF;
  const long long number = integer_or(item, 62, Dxf_colour::BY_LAYER), rgb = integer_or(item, 420, -1);
  Dxf_colour colour;
  if (number >= -Dxf_colour::BY_LAYER && number <= Dxf_colour::BY_LAYER)
    colour.number = static_cast<int>(number < 0 ? -number : number);
  if (rgb >= 0 && rgb <= WHITE) colour.rgb = static_cast<int>(rgb);
  return colour;
}

bool begins(const std::string& key, std::string_view head) { return key.compare(0, head.size(), head) == 0; }

Dxf_insertion insertion_of(const Dxf_item& item) {
  constexpr long long MOST = 1000;
  Dxf_insertion insertion;
  insertion.block = dxf_key(item.text(2, ""));
  insertion.columns = std::max(1LL, item.integer(70, 1));
  insertion.rows = std::max(1LL, item.integer(71, 1));
  if (insertion.columns > MOST || insertion.rows > MOST) throw Dxf_left_out("more than 1000 rows or columns");
  const double x_scale = item.real(41, 1), y_scale = item.real(42, 1);
  if (x_scale == 0 || y_scale == 0) throw Dxf_left_out("scale 0");
  insertion.scale = svg_scaling(x_scale, y_scale);
  insertion.place = svg_scaling(is_seen_from_below(item) ? -1 : 1, 1) * svg_translation(item.real(10), item.real(20)) *
                    svg_rotation(item.real(50, 0));
  insertion.column_step = item.real(44, 0);
  insertion.row_step = item.real(45, 0);
  return insertion;
}

// Takes items one after the other.
class Dxf_collector {
 public:
  Dxf_contents contents;

  void take(Dxf_item&& item) {
    if (item.kind == "VERTEX" && polyline_) {
      polyline_->is_cut = item.is_cut;
      vertices_.push_back(std::move(item));
      return;
    }
    finish();
    if (item.kind == "SECTION") begin_section(item);
    else if (item.kind == "ENDSEC") section_.clear(), open_ = nullptr;
    else if (section_ == "TABLES" && item.kind == "LAYER") add_layer(item);
    else if (section_ == "BLOCKS" && item.kind == "BLOCK") open(item);
    else if (section_ == "BLOCKS" && item.kind == "ENDBLK") open_ = nullptr;
    else if (section_ == "ENTITIES" || (section_ == "BLOCKS" && open_ != nullptr)) add_entity(std::move(item));
  }
  /// Ends with the last item.
  [[nodiscard]] Dxf_contents result() && {
    finish();
    return std::move(contents);
  }

 private:
  // A polyline has vertices behind it.
  void finish() {
    if (!polyline_) return;
    const Dxf_item polyline = std::move(*polyline_);
    polyline_.reset();
    add(polyline);
    vertices_.clear();
  }

  void begin_section(const Dxf_item& item) {
    section_ = item.text(2, "");
    if (section_ == "HEADER") contents.unit_in_mm = header_unit(item);
  }

  void add_layer(const Dxf_item& item) {
    constexpr int FROZEN = 1;
    contents.layers[dxf_key(item.text(2, ""))] = {integer_or(item, 62, 0) < 0, (integer_or(item, 70, 0) & FROZEN) != 0,
                                                  colour_of(item)};
  }

  void open(const Dxf_item& item) {
    constexpr int OF_OTHER_FILE = 4 | 8;
    const std::string key = dxf_key(item.text(2, ""));
    is_paper_ = begins(key, "*paper_space") || begins(key, "$paper_space");
    if (key.empty() || is_paper_ || begins(key, "*model_space") || begins(key, "$model_space")) {
      open_ = &contents.drawing;
      return;
    }
    open_ = &contents.blocks[key];
    try {
      open_->base = {item.real(10, 0), item.real(20, 0)};
      open_->is_elsewhere = (item.integer(70, 0) & OF_OTHER_FILE) != 0;
    } catch (const Dxf_left_out& left_out) {
      open_ = nullptr;  // insertions miss it
      contents.blocks.erase(key);
    }
  }

  void add_entity(Dxf_item&& item) {
    // Ends of lists, and windows of paper space, are nothing of the drawing.
    if (item.kind == "SEQEND" || item.kind == "VERTEX" || item.kind == "VIEWPORT") return;
    if (item.kind == "POLYLINE") polyline_ = std::move(item);
    else add(item);
  }

  void add(const Dxf_item& item) {
    Dxf_entity entity;
    entity.kind = one_line(item.kind, LONGEST_KIND);
    entity.layer = item.text(8, "0");
    entity.name = item.name;
    entity.number = ++numbers_[entity.noun()];
    entity.colour = colour_of(item);
    entity.arc_size = arc_size(item);
    contents.digits.take(item);
    try {
      entity.is_invisible = item.integer(60, 0) == 1;
      entity.is_in_paper = section_ == "ENTITIES" ? item.integer(67, 0) == 1 : is_paper_ && open_ == &contents.drawing;
      if (item.is_cut) throw Dxf_left_out("the file ends in it");
      if (item.kind == "INSERT") {
        entity.insertion = insertion_of(item);
      } else {
        Dxf_drawn drawn = dxf_entity_curves(item, vertices_);
        entity.curves = std::move(drawn.curves);
        entity.fault = std::move(drawn.fault);
      }
    } catch (const Dxf_left_out& left_out) {
      entity.reason = left_out.what();
    }
    (section_ == "ENTITIES" ? contents.drawing : *open_).entities.push_back(std::move(entity));
  }

  std::string section_;
  Dxf_block* open_ = nullptr;  // in the section of blocks
  bool is_paper_ = false;      // the block that is open is a sheet
  std::map<std::string, std::size_t> numbers_;
  std::optional<Dxf_item> polyline_;
  std::vector<Dxf_item> vertices_;
};

}  // namespace

std::string Dxf_entity::noun() const { return kind == "LWPOLYLINE" ? "polyline" : lower(kind); }

std::string dxf_key(std::string_view name) { return lower(name); }

Dxf_contents dxf_contents(std::string_view text, const std::string& file) {
  Dxf_items items(text, file);
  Dxf_collector collector;
  while (std::optional<Dxf_item> item = items.next()) collector.take(std::move(*item));
  collector.contents.has_end = items.has_end();
  return std::move(collector).result();
}

}  // namespace bounding_arcs_tool
