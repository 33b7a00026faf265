// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walks an SVG document and collects the subpaths of its shapes.

#include "Curve_readers.h"
#include "Input_text.h"
#include "Svg_document.h"
#include "Svg_fill_rules.h"
#include "Svg_notes.h"
#include "Svg_style.h"
#include "svg_colour.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
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

// Elements that show what has no outline here, and what is said of them.
struct Without_curve {
  std::string_view name, reason;
};
constexpr Without_curve WITHOUT_CURVE[] = {{"text", "convert it to paths"},
                                           {"flowRoot", "convert it to paths"},
                                           {"image", "has no curve"},
                                           {"foreignObject", "has no curve"}};

// Where an element stands, and what it inherits. A use element gives its size to a symbol or svg that it refers to.
struct Surroundings {
  Svg_transform transform;
  Svg_viewport viewport;
  std::size_t depth = 0;
  const Svg_element* use = nullptr;
  Fill_rule rule = Fill_rule::NONZERO;
  Curve_record::Filling filling = Curve_record::CLOSED;  // of open subpaths: shapes are filled unless told otherwise
  bool is_visible = true;
  std::string layer;                   // the innermost one of Inkscape
  int stroke_rgb = -1, fill_rgb = -1;  // colours, or none

  // Style sheets go before attributes, but not before style attributes.
  void inherit(const Svg_style& style, bool has_sheet_that_fills) {
    const std::string fill = style.value("fill");
    for (const auto& [property, colour] :
         {std::pair("stroke", &Surroundings::stroke_rgb), std::pair("fill", &Surroundings::fill_rgb)})
      if (const std::string found = style.value(property); !found.empty() && found != "inherit")
        this->*colour = svg_colour(found);
    if (has_sheet_that_fills && style.declared("fill").empty()) filling = Curve_record::UNKNOWN;
    else if (fill == "none" || fill == "transparent") filling = Curve_record::NO_INSIDE;
    else if (!fill.empty() && fill != "inherit" && fill != "unset") filling = Curve_record::CLOSED;
    const std::string filled = style.value("fill-rule", {"nonzero", "evenodd", "initial", "inherit"});
    if (filled == "evenodd") rule = Fill_rule::EVEN_ODD;
    if (filled == "nonzero" || filled == "initial") rule = Fill_rule::NONZERO;
    const std::string seen = style.value("visibility", {"visible", "hidden", "collapse", "initial", "inherit"});
    if (seen == "hidden" || seen == "collapse") is_visible = false;
    if (seen == "visible" || seen == "initial") is_visible = true;
  }
};

class Svg_reader {
 public:
  Svg_reader(const std::string& text, const std::string& file, const Curve_file::Options& options)
      : document_(text, file, notes_), options_(options) {}

  Curve_file read() {
    const Svg_element root = document_.root();
    const Svg_style style(root.node());
    Surroundings surroundings;
    surroundings.viewport = root_viewport(root);
    surroundings.inherit(style, document_.has_sheet_that_fills());
    around_.push_back(root.node());
    if (is_displayed(root, style)) visit_children(root, surroundings);
    const Fill_rule rule = options_.rule ? *options_.rule : rules_.most(notes_);
    if (records_.empty()) fail_without_curve(root);
    return {std::move(records_), rule, notes_.notes(), root.root_unit_in_mm(), 0, root.root_page()};
  }

 private:
  void visit(const Svg_element& element, Surroundings surroundings) {
    if (++surroundings.depth > MAXIMUM_SVG_NESTING)
      document_.fail(element,
                     "expected at most " + std::to_string(MAXIMUM_SVG_NESTING) + " levels of elements, found more");
    count(element, 1 + element.attribute_bytes() / BYTES_COUNTED_AS_ONE);
    if (!element.is_wanted()) return;
    around_.resize(surroundings.depth);
    around_.push_back(element.node());
    const Svg_style style(element.node());
    surroundings.inherit(style, document_.has_sheet_that_fills());
    const bool is_seen = options_.with_hidden || surroundings.is_visible;
    try {
      if (is_svg_shape(element.name())) visit_shape(element, style, surroundings, is_seen);
      else if (is_group(element, surroundings)) visit_group(element, style, surroundings);
      else if (is_seen && style.value("display") != "none") note_without_curve(element.name());
    } catch (const Svg_error& error) {
      leave_out(element, error);
    }
  }

  static bool is_viewport(const Svg_element& element, const Surroundings& surroundings) {
    return element.name() == "svg" || (element.name() == "symbol" && surroundings.use != nullptr);
  }

  static bool is_group(const Svg_element& element, const Surroundings& surroundings) {
    const std::string_view name = element.name();
    return name == "g" || name == "a" || name == "switch" || name == "use" || is_viewport(element, surroundings);
  }

  void visit_shape(const Svg_element& element, const Svg_style& style, Surroundings& surroundings, bool is_seen) {
    if (!is_displayed(element, style)) return;
    if (!is_seen) return notes_.add(element.name(), "hidden");
    style.note_unread(element.name(), notes_);
    surroundings.transform = surroundings.transform * element.transform(style, surroundings.viewport);
    draw(element, surroundings);
  }

  void visit_group(const Svg_element& element, const Svg_style& style, Surroundings& surroundings) {
    if (!is_displayed(element, style)) return;
    style.note_unread(element.name(), notes_);
    surroundings.transform = surroundings.transform * element.transform(style, surroundings.viewport);
    if (element.is_layer()) surroundings.layer = valid_utf8(element.layer_name());
    if (is_viewport(element, surroundings) && !enter_viewport(element, surroundings))
      return notes_.add(element.name(), "has no size");
    surroundings.use = nullptr;
    if (element.name() == "use") return visit_reference(element, surroundings);
    if (element.name() == "switch") return visit_first_choice(element, surroundings);
    visit_children(element, surroundings);
  }

  // Whether it is not hidden with all that is in it.
  bool is_displayed(const Svg_element& element, const Svg_style& style) {
    const bool is_hidden = !options_.with_hidden && style.value("display") == "none";
    if (is_hidden) notes_.add(element.name(), "hidden");
    return !is_hidden;
  }

  void note_without_curve(std::string_view name) {
    for (const Without_curve& known : WITHOUT_CURVE)
      if (name == known.name) notes_.add(name, known.reason);
  }

  // What is wrong with an element costs that element, not the drawing. What was read of it in vain counts in full.
  void leave_out(const Svg_element& element, const Svg_error& error) {
    count(element, element.attribute_bytes());
    if (!first_error_) first_error_ = document_.error(element, error);
    notes_.add(element.name(), "cannot be drawn", Svg_notes::LEFT_OUT,
               [&] { return document_.place(element, &error) + ": " + error.what(); });
  }

  // Only per cent depend on it; viewers take a drawing of an unknown size for one of the size of their window.
  Svg_viewport root_viewport(const Svg_element& root) {
    try {
      return root.root_viewport();
    } catch (const Svg_error& error) {
      notes_.add("svg", "per cent are of 300 by 150", Svg_notes::READ,
                 [&] { return document_.place(root, &error) + ": " + error.what(); });
      return DEFAULT_SVG_VIEWPORT;
    }
  }

  [[noreturn]] void fail_without_curve(const Svg_element& root) const {
    if (first_error_) throw Input_error(*first_error_);
    const std::vector<Curve_file::Note> notes = notes_.notes();
    document_.fail(root, "no curve in the drawing" + (notes.empty() ? "" : "; " + Curve_file::text_of(notes)));
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

  void visit_reference(const Svg_element& use, Surroundings& surroundings) {
    const std::string_view reference = use.reference();
    if (reference.empty()) throw Svg_error(0, "expected a reference to an element, found none");
    if (reference.front() != '#')
      throw Svg_error(0, "expected a reference into this file, found " + in_quotes(reference));
    const pugi::xml_node target = document_.by_id(reference.substr(1));
    if (!target)
      throw Svg_error(0, "expected an element with the id " + in_quotes(reference.substr(1)) + ", found none");
    if (std::find(around_.begin(), around_.end(), target) != around_.end())
      throw Svg_error(0, "expected no use of an element within itself, found " + in_quotes(reference));
    const auto [width, height] = surroundings.viewport;
    surroundings.transform =
        surroundings.transform * svg_translation(use.length("x", width, 0), use.length("y", height, 0));
    surroundings.use = &use;
    visit(Svg_element(target), surroundings);
  }

  void draw(const Svg_element& element, const Surroundings& surroundings) {
    Svg_outline outline(surroundings.transform);
    draw_svg_shape(element, surroundings.viewport, outline);
    const int drawn = ++numbers_[std::string(element.name())];
    const std::string name =
        element.id().empty() ? std::string(element.name()) + std::to_string(drawn) : valid_utf8(element.id());
    std::vector<Svg_subpath> subpaths = std::move(outline).subpaths();
    if (subpaths.empty()) notes_.add(element.name(), "draws nothing");
    rules_.add(surroundings.rule, element.name(), subpaths, surroundings.filling == Curve_record::CLOSED);
    for (std::size_t i = 0; i < subpaths.size(); ++i) {
      count(element, subpaths[i].beziers.size() + name.size() / NAME_BYTES_COUNTED_AS_ONE);
      const std::string number = subpaths.size() > 1 ? '.' + std::to_string(i + 1) : "";
      records_.push_back(record(std::move(subpaths[i]), name + number, surroundings));
    }
  }

  static Curve_record record(Svg_subpath subpath, std::string name, const Surroundings& surroundings) {
    Curve_record record;
    if (subpath.can_be_closed()) record.filling = surroundings.filling;
    record.layer = surroundings.layer;
    record.colour.rgb = surroundings.stroke_rgb >= 0 ? surroundings.stroke_rgb : surroundings.fill_rgb;
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
      document_.fail(element, "expected at most " + std::to_string(MAXIMUM_COPIES) +
                                  " elements and pieces added by use elements, found more, or repeated long ids");
  }

  Svg_notes notes_;
  Svg_document document_;
  Curve_file::Options options_;
  Svg_fill_rules rules_;
  std::optional<Input_error> first_error_;
  std::vector<pugi::xml_node> around_;  // the elements down to the current place, the root first
  std::map<std::string, int> numbers_;  // shapes read so far, by name
  std::size_t parts_ = 0;
  std::vector<Curve_record> records_;
};

}  // namespace

Curve_file read_svg_curves(const std::string& text, const std::string& file, const Curve_file::Options& options) {
  if (text.size() > MAXIMUM_SVG_SIZE)
    throw Input_error(file, "file",
                      "expected at most " + std::to_string(MAXIMUM_SVG_SIZE) + " bytes of SVG, found more");
  return Svg_reader(text, file, options).read();
}

}  // namespace bounding_arcs_tool
