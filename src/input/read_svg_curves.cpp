// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks an SVG document and collects the subpaths of its shapes.

#include "Curve_readers.h"
#include "Input_text.h"
#include "Svg_document.h"

#include <algorithm>
#include <map>
#include <utility>

namespace bounding_arcs_tool {

namespace {

// Keeps the recursion within a megabyte of stack; drawings nest some twenty levels.
constexpr std::size_t MAXIMUM_SVG_NESTING = 256;

// Elements, pieces, other nodes passed by and hundreds of bytes of attributes that use elements may add to those that
// the file spells out, each of which takes a byte at least: a few nested use elements, or many uses of one group of
// many nodes, would otherwise fill any memory or take any time.
constexpr std::size_t MAXIMUM_COPIES = 1000000;
constexpr std::size_t BYTES_COUNTED_AS_ONE = 100;

// How many bytes of a name count as one. Every subpath of an element has a copy of its name: a path may have as many
// subpaths as its id has bytes.
constexpr std::size_t NAME_BYTES_COUNTED_AS_ONE = 16;

// Where an element stands. A use element gives its size to a symbol or svg that it refers to.
struct Surroundings {
  Svg_transform transform;
  Svg_viewport viewport;
  std::size_t depth = 0;
  const Svg_element* use = nullptr;
};

class Svg_reader {
 public:
  Svg_reader(const std::string& text, const std::string& file) : document_(text, file) {}

  std::vector<Curve_record> read() {
    const Svg_element root = document_.root();
    Surroundings surroundings;
    document_.guarded(root, [&] { surroundings.viewport = root.root_viewport(); });
    if (!root.is_hidden()) visit_children(root, surroundings);
    if (records_.empty()) document_.fail(root, "no curve in the drawing");
    return std::move(records_);
  }

 private:
  void visit(const Svg_element& element, Surroundings surroundings) {
    if (++surroundings.depth > MAXIMUM_SVG_NESTING)
      document_.fail(element, "nested deeper than " + std::to_string(MAXIMUM_SVG_NESTING) + " levels");
    count(element, 1 + element.attribute_bytes() / BYTES_COUNTED_AS_ONE);
    if (element.is_hidden() || !element.is_wanted()) return;
    const std::string_view name = element.name();
    const bool is_viewport = name == "svg" || (name == "symbol" && surroundings.use != nullptr);
    const bool is_group = name == "g" || name == "a" || name == "switch" || name == "use" || is_viewport;
    if (!is_group && !is_svg_shape(name)) return;
    document_.guarded(element, [&] { surroundings.transform = surroundings.transform * element.transform(); });
    if (is_svg_shape(name)) return draw(element, surroundings);
    bool has_room = true;
    if (is_viewport) document_.guarded(element, [&] { has_room = enter_viewport(element, surroundings); });
    if (!has_room) return;
    surroundings.use = nullptr;
    if (name == "use") return visit_reference(element, surroundings);
    if (name == "switch") return visit_first_choice(element, surroundings);
    visit_children(element, surroundings);
  }

  void visit_children(const Svg_element& element, const Surroundings& surroundings) {
    for (const pugi::xml_node& child : element.node().children())
      if (child.type() == pugi::node_element) visit(Svg_element(child), surroundings);
      else count(element, 1);
  }

  void visit_first_choice(const Svg_element& element, const Surroundings& surroundings) {
    for (const pugi::xml_node& child : element.node().children()) {
      const Svg_element choice(child);
      count(element, 1);
      if (child.type() != pugi::node_element || !choice.is_svg() || !choice.is_wanted()) continue;
      return visit(choice, surroundings);
    }
  }

  // Whether the viewport has any size.
  static bool enter_viewport(const Svg_element& element, Surroundings& surroundings) {
    const Svg_viewport outer = surroundings.viewport;
    const double w = outer.width, h = outer.height;
    Svg_viewport inner{element.size("width", w, w), element.size("height", h, h)};
    if (surroundings.use != nullptr)
      inner = {surroundings.use->size("width", w, inner.width), surroundings.use->size("height", h, inner.height)};
    if (inner.width == 0 || inner.height == 0) return false;
    const Svg_transform origin = svg_translation(element.length("x", w, 0), element.length("y", h, 0));
    surroundings.transform = surroundings.transform * origin * element.viewbox_transform(inner);
    surroundings.viewport = inner;
    return true;
  }

  void visit_reference(const Svg_element& use, Surroundings surroundings) {
    const std::string_view reference = use.reference();
    if (reference.empty()) return;
    if (reference.front() != '#') document_.fail(use, in_quotes(reference) + " is not in this file");
    const pugi::xml_node target = document_.by_id(reference.substr(1));
    if (!target) document_.fail(use, "no element has the id " + in_quotes(reference.substr(1)));
    if (std::find(used_.begin(), used_.end(), target) != used_.end())
      document_.fail(use, in_quotes(reference) + " contains a use of itself");
    document_.guarded(use, [&] {
      const auto [width, height] = surroundings.viewport;
      surroundings.transform =
          surroundings.transform * svg_translation(use.length("x", width, 0), use.length("y", height, 0));
    });
    surroundings.use = &use;
    used_.push_back(target);
    visit(Svg_element(target), surroundings);
    used_.pop_back();
  }

  void draw(const Svg_element& element, const Surroundings& surroundings) {
    Svg_outline outline(surroundings.transform);
    document_.guarded(element, [&] { draw_svg_shape(element, surroundings.viewport, outline); });
    const int drawn = ++numbers_[std::string(element.name())];
    const std::string name =
        element.id().empty() ? std::string(element.name()) + std::to_string(drawn) : valid_utf8(element.id());
    std::vector<Svg_subpath> subpaths = std::move(outline).subpaths();
    for (std::size_t i = 0; i < subpaths.size(); ++i) {
      count(element, subpaths[i].beziers.size() + name.size() / NAME_BYTES_COUNTED_AS_ONE);
      const std::string number = subpaths.size() > 1 ? '.' + std::to_string(i + 1) : "";
      records_.push_back(record(std::move(subpaths[i]), name + number));
    }
  }

  static Curve_record record(Svg_subpath subpath, std::string name) {
    Curve_record record;
    record.name = std::move(name);
    record.type = Curve_record::PATH;
    record.y_is_down = true;
    record.beziers = std::move(subpath.beziers);
    record.closed = subpath.closed;
    for (const Bezier_curve_2<double>& piece : record.beziers) record.degree = std::max(record.degree, piece.degree());
    return record;
  }

  void count(const Svg_element& element, std::size_t parts) {
    parts_ += parts;
    if (parts_ > document_.size() + MAXIMUM_COPIES)
      document_.fail(element, "use elements add more than " + std::to_string(MAXIMUM_COPIES) +
                                  " elements and pieces, or long ids are repeated");
  }

  Svg_document document_;
  std::vector<pugi::xml_node> used_;    // what the use elements around the current place refer to
  std::map<std::string, int> numbers_;  // shapes read so far, by name
  std::size_t parts_ = 0;
  std::vector<Curve_record> records_;
};

}  // namespace

Curve_file read_svg_curves(const std::string& text, const std::string& file) {
  if (text.size() > MAXIMUM_SVG_SIZE)
    throw Input_error(file, "file", "is longer than " + std::to_string(MAXIMUM_SVG_SIZE) + " bytes, too long for SVG");
  return {Svg_reader(text, file).read(), CGAL::Bounding_arcs::Fill_rule::NONZERO, {}};
}

}  // namespace bounding_arcs_tool
