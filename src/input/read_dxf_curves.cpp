// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes curves of what a DXF file holds: blocks where they are inserted, without what is hidden or in paper space.

#include "Curve_readers.h"
#include "Dxf_contents.h"
#include "Dxf_text.h"
#include "Input_text.h"

#include <CGAL/Bbox_2.h>
#include <CGAL/Bounding_arcs_2/query/closest_point.h>
#include <CGAL/Bounding_arcs_2/tree/Bounding_arc_tree_2.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Curve_record;

// Keeps what insertions make of a small file within a megabyte of stack and some hundred megabytes.
constexpr std::size_t MAXIMUM_BLOCK_NESTING = 64, MAXIMUM_ENTITIES = 1000000;

// Counts what is left out, or read otherwise than it stands there, in the order in which it is met.
class Dxf_notes {
 public:
  // An entity of a block counts once, however often the block is inserted.
  void add(const Dxf_entity& entity, const std::string& reason, bool is_read = false) {
    if (!entities_.insert(&entity).second) return;
    const auto [place, is_new] = places_.try_emplace({entity.kind, reason}, notes.size());
    if (is_new) notes.push_back({0, entity.kind, reason, is_read});
    ++notes[place->second].count;
  }

  std::vector<Curve_file::Note> notes;

 private:
  std::set<const Dxf_entity*> entities_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;
};

// Curves that others may run along.
class Known_curves {
 public:
  Known_curves(const std::vector<Curve_record>& records, double rounding) : rounding_(rounding) {
    if (records.empty()) return;
    try {
      tree_.emplace(CGAL::Bounding_arcs::drawing<double>(records));
    } catch (const std::invalid_argument&) {
      tree_.reset();  // what is not served is said later, and by its name
    }
  }
  // Whether points of each piece are on one of the curves.
  [[nodiscard]] bool has(const Curve_record& record) const {
    // Programs write hatches with digits and directions of their own; an outline so far from another is one more.
    constexpr double ASIDE = 0x1p-14;  // of its extent
    CGAL::Bbox_2 box;
    for (const auto& piece : record.beziers)
      for (const Xy<double>& p : piece.control_points()) box += CGAL::Bbox_2(p.x, p.y, p.x, p.y);
    const double aside = std::max(rounding_, ASIDE * std::max(box.x_span(), box.y_span()));
    return std::all_of(record.beziers.begin(), record.beziers.end(), [&](const auto& piece) {
      for (const double t : {0.0, 0.29, 0.5, 0.83}) {
        const auto found = tree_ ? closest_point(*tree_, piece.point(t)) : std::nullopt;
        if (!found || !(found->distance.upper <= aside)) return false;
      }
      return true;
    });
  }

 private:
  std::optional<CGAL::Bounding_arcs::Bounding_arc_tree_2> tree_;
  double rounding_;
};

// Makes records of entities, those of inserted blocks where they come to stand.
class Dxf_expansion {
 public:
  Dxf_expansion(const Dxf_contents& contents, const Curve_file::Options& options, std::string file)
      : contents_(contents), options_(options), file_(std::move(file)) {}

  // What is drawn takes of what is around it: nothing, or the insertion of a block.
  struct Around {
    Svg_transform transform;
    std::string layer;
    Curve_record::Colour colour;
  };

  void visit(const Dxf_block& block, const Around& around) {
    for (const Dxf_entity& entity : block.entities) {
      count(entity, 1);
      // what is on layer 0 of a block goes to the layer of the insertion
      const std::string& layer = entity.layer == "0" && !inserted_.empty() ? around.layer : entity.layer;
      const Around here{around.transform, layer, seen_colour(entity.colour, layer, around.colour)};
      std::string reason = reason_to_hide(entity, layer);
      if (reason.empty()) reason = entity.reason;
      if (reason.empty() && entity.kind == "INSERT") reason = insert(entity, here);
      if (reason.empty()) reason = add(entity, here);
      if (!is_told(layer)) continue;
      if (!reason.empty()) notes_.add(entity, reason);
      else if (!entity.fault.empty()) notes_.add(entity, entity.fault, true);
    }
  }
  Curve_file result() && {
    leave_out_known_outlines();
    for (std::size_t i = 0; i < records_.size(); ++i)
      if (numbers_[layers_[i]] > 1 && !layers_[i].empty() && records_[i].name == valid_utf8(layers_[i]))
        records_[i].name += "." + std::to_string(++named_[layers_[i]]);
    if (!contents_.has_end) notes_.notes.push_back({1, "file", "no EOF at its end", true});
    if (records_.empty())
      throw Input_error(
          file_, "file",
          "no curve in the drawing" + (notes_.notes.empty() ? "" : "; " + Curve_file::text_of(notes_.notes)));
    return {std::move(records_), options_.rule.value_or(CGAL::Bounding_arcs::Fill_rule::EVEN_ODD),
            std::move(notes_.notes), contents_.unit_in_mm, contents_.digits.rounding()};
  }

 private:
  void count(const Dxf_entity& entity, std::size_t copies) {
    copies_ += copies;
    if (copies_ > MAXIMUM_ENTITIES)
      throw Input_error(
          file_, entity.noun() + " " + std::to_string(entity.number),
          "expected at most " + std::to_string(MAXIMUM_ENTITIES) + " entities and pieces, found more than that");
  }

  [[nodiscard]] bool is_told(const std::string& layer) const {
    const auto is_it = [&](const std::string& asked) { return dxf_key(asked) == dxf_key(layer); };
    return options_.layers.empty() || std::any_of(options_.layers.begin(), options_.layers.end(), is_it);
  }

  // What a layer that is off has in blocks on other layers is seen; one that is frozen hides that, too.
  [[nodiscard]] std::string reason_to_hide(const Dxf_entity& entity, const std::string& layer) const {
    if (entity.is_in_paper && !options_.with_paper) return "in paper space";
    if (options_.with_hidden) return "";
    if (entity.is_invisible) return "invisible";
    const auto found = contents_.layers.find(dxf_key(layer));
    if (found == contents_.layers.end()) return "";
    if (found->second.is_frozen) return "on a frozen layer";
    return found->second.is_off && entity.kind != "INSERT" ? "on a layer that is off" : "";
  }

  // What is by block outside of one is as a CAD program shows what has no colour.
  [[nodiscard]] Curve_record::Colour seen_colour(const Dxf_colour& colour, const std::string& layer,
                                                 const Curve_record::Colour& of_block) const {
    constexpr int BLACK_OR_WHITE = 7;
    if (colour.rgb >= 0 || (colour.number != Dxf_colour::BY_LAYER && colour.number != Dxf_colour::BY_BLOCK))
      return {colour.number % Dxf_colour::BY_LAYER, colour.rgb};
    if (colour.number == Dxf_colour::BY_BLOCK)
      return inserted_.empty() ? Curve_record::Colour{BLACK_OR_WHITE, -1} : of_block;
    const auto found = contents_.layers.find(dxf_key(layer));
    if (found == contents_.layers.end()) return {BLACK_OR_WHITE, -1};
    const Dxf_colour& of_layer = found->second.colour;
    return {of_layer.number % Dxf_colour::BY_LAYER, of_layer.rgb};
  }

  // \return why it is left out, or nothing
  std::string insert(const Dxf_entity& entity, const Around& here) {
    const auto found = contents_.blocks.find(entity.insertion.block);
    if (found == contents_.blocks.end()) return "its block is missing";
    const Dxf_block& block = found->second;
    if (block.is_elsewhere && block.entities.empty()) return "its block is in another file";
    if (std::find(inserted_.begin(), inserted_.end(), &block) != inserted_.end()) return "in its own block";
    if (inserted_.size() >= MAXIMUM_BLOCK_NESTING) return "nested deeper than 64 blocks";
    inserted_.push_back(&block);
    for (long long i = 0; i < entity.insertion.columns; ++i)
      for (long long k = 0; k < entity.insertion.rows; ++k) {
        count(entity, 1);
        visit(block, {here.transform * entity.insertion.at(i, k) * svg_translation(-block.base.x, -block.base.y),
                      here.layer, here.colour});
      }
    inserted_.pop_back();
    return "";
  }

  // Numbers of a curve, whichever way it runs.
  static std::vector<double> key_of(const Curve_record& record) {
    std::vector<double> key, back;
    for (const auto& bezier : record.beziers) {
      for (const Xy<double>& p : bezier.control_points()) key.insert(key.end(), {p.x, p.y});
      key.insert(key.end(), bezier.weights().begin(), bezier.weights().end());
    }
    for (auto bezier = record.beziers.rbegin(); bezier != record.beziers.rend(); ++bezier) {
      const auto& points = bezier->control_points();
      for (auto p = points.rbegin(); p != points.rend(); ++p) back.insert(back.end(), {p->x, p->y});
      back.insert(back.end(), bezier->weights().rbegin(), bezier->weights().rend());
    }
    return std::min(key, back);
  }
  // Whether a layer has the curve already. Programs draw lines twice, and twice is never by the even-odd rule.
  bool is_there(const Curve_record& record, const std::string& layer) {
    const std::vector<double> key = key_of(record);
    std::vector<std::size_t>& known = by_key_[boost::hash_range(key.begin(), key.end())];
    for (const std::size_t i : known)
      if (layers_[i] == layer && key_of(records_[i]) == key) return true;
    known.push_back(records_.size());
    return false;
  }

  // Leaves out outlines of hatches that other curves run along, or other hatches have; others are read.
  void leave_out_known_outlines() {
    if (outlines_.empty()) return;
    std::vector<bool> is_outline(records_.size());
    for (const auto& [i, hatch] : outlines_) is_outline[i] = true;
    std::vector<Curve_record> others;
    for (std::size_t i = 0; i < records_.size(); ++i)
      if (!is_outline[i]) others.push_back(records_[i]);
    const Known_curves known(others, contents_.digits.rounding());
    std::vector<bool> is_left_out(records_.size());
    std::set<const Dxf_entity*> read;
    std::set<std::vector<double>> outlines;
    for (const auto& [i, hatch] : outlines_) {
      is_left_out[i] = known.has(records_[i]) || !outlines.insert(key_of(records_[i])).second;
      if (!is_left_out[i]) read.insert(hatch);
    }
    for (const auto& [i, hatch] : outlines_) {
      if (!is_told(layers_[i].empty() ? "0" : layers_[i])) continue;
      if (read.count(hatch) > 0) notes_.add(*hatch, "by its outline, which no other curves draw", true);
      else notes_.add(*hatch, "its outline is drawn by other curves");
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < records_.size(); ++i) {
      if (is_left_out[i]) {
        if (records_[i].name == valid_utf8(layers_[i])) --numbers_[layers_[i]];
        continue;
      }
      if (kept != i) records_[kept] = std::move(records_[i]), layers_[kept] = std::move(layers_[i]);
      ++kept;
    }
    records_.resize(kept);
    layers_.resize(kept);
  }

  // \return why it is left out, or nothing
  std::string add(const Dxf_entity& entity, const Around& here) {
    const std::string& layer = here.layer;
    const bool is_named = !layer.empty() && layer != "0";
    for (std::size_t i = 0; i < entity.curves.size(); ++i) {
      Curve_record record;
      record.type = Curve_record::PATH;
      record.layer = valid_utf8(layer);
      record.colour = here.colour;
      const auto& [a, b, c, d, e, f] = here.transform;
      record.end_error =
          std::max(std::hypot(a, b), std::hypot(c, d)) * contents_.digits.end_error(entity.kind, entity.arc_size);
      record.name = is_named ? valid_utf8(layer) : entity.noun() + std::to_string(entity.number);
      if (!entity.name.empty()) record.name = valid_utf8(entity.name);
      else if (!is_named && entity.curves.size() > 1) record.name += "." + std::to_string(i + 1);
      try {
        record.beziers = transformed(entity.curves[i], here.transform);
      } catch (const std::invalid_argument& error) {
        return error.what();
      }
      if (entity.kind != "HATCH" && is_there(record, is_named ? layer : "")) return "there twice";
      record.closed = record.beziers.front().control_points().front() == record.beziers.back().control_points().back();
      for (const auto& bezier : record.beziers) record.degree = std::max(record.degree, bezier.degree());
      count(entity, record.beziers.size());
      layers_.push_back(is_named ? layer : "");
      if (entity.name.empty()) ++numbers_[layers_.back()];
      if (entity.kind == "HATCH") outlines_.emplace_back(records_.size(), &entity);
      records_.push_back(std::move(record));
    }
    return "";
  }

  const Dxf_contents& contents_;
  const Curve_file::Options& options_;
  std::string file_;
  Dxf_notes notes_;
  std::vector<const Dxf_block*> inserted_;  // the blocks that are open, the outermost first
  std::size_t copies_ = 0;
  std::vector<Curve_record> records_;
  std::vector<std::string> layers_;                                   // of each record; empty for none
  std::vector<std::pair<std::size_t, const Dxf_entity*>> outlines_;   // records of hatches
  std::unordered_map<std::size_t, std::vector<std::size_t>> by_key_;  // records by their numbers
  std::map<std::string, std::size_t> numbers_, named_;  // records of a layer, and those that have their number
};

}  // namespace

Curve_file read_dxf_curves(std::string_view text, const std::string& file, const Curve_file::Options& options) {
  const std::optional<std::string> in_utf8 = dxf_as_utf8(text);
  const Dxf_contents contents = dxf_contents(in_utf8 ? *in_utf8 : text, file);
  Dxf_expansion expansion(contents, options, file);
  expansion.visit(contents.drawing, {});
  return std::move(expansion).result();
}

}  // namespace bounding_arcs_tool
