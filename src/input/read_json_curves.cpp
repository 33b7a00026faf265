// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A JSON text to curve records, in one pass that keeps no document: the parser's events go to the curve that they are
// of, and each is work for its own value only, so that time is linear in the text.

#include "Curve_readers.h"
#include "Input_text.h"
#include "Json_curve.h"
#include "Json_place.h"

#include <utility>

namespace bounding_arcs_tool {

namespace {

using nlohmann::json;

std::string shown(const json& value) {
  return value.is_string() ? in_quotes(value.get_ref<const std::string&>()) : value.dump();
}

// What the parser says without its own prefix "[json.exception...] parse error at line 1, column 2: ".
std::string bare_reason(const std::string& what) {
  const std::size_t column = what.find("column ");
  const std::size_t end = column == what.npos ? what.find("] ") : what.find(": ", column);
  return end == what.npos ? what : what.substr(end + 2);
}

// Takes the events of the parser, whose names and signatures these are.
class Json_reader {
 public:
  Json_reader(const std::string& text, const std::string& file, const std::string& stem)
      : text_(text), stem_(stem), place_(file) {}

  bool null() { return scalar(json()); }
  bool boolean(bool x) { return scalar(json(x)); }
  bool number_integer(json::number_integer_t x) { return scalar(json(x)); }
  bool number_unsigned(json::number_unsigned_t x) { return scalar(json(x)); }
  bool number_float(json::number_float_t x, const std::string&) { return scalar(json(x)); }
  bool string(std::string& x) { return scalar(json(std::move(x))); }
  static bool binary(json::binary_t&) { return true; }  // not in JSON
  bool start_object(std::size_t) { return open(false); }
  bool end_object() { return close(false); }
  bool start_array(std::size_t) { return open(true); }
  bool end_array() { return close(true); }

  bool key(const std::string& key) {
    place_.enter_key(key);
    has_list_ = has_list_ || (levels_.size() == 1 && key == "curves");
    has_offsets_ = has_offsets_ || (levels_.size() == 1 && key == "offsets");
    return true;
  }

  bool parse_error(std::size_t byte, const std::string&, const json::exception& error) {
    if (dynamic_cast<const json::out_of_range*>(&error) != nullptr)
      throw Input_error(place_.file(), place_.path(), "expected a finite number, found " + bare_reason(error.what()));
    throw Input_error(place_.file(), text_place(text_, byte > 0 ? byte - 1 : 0), bare_reason(error.what()));
  }

  /// The curves, when the text is over.
  Curve_file result() {
    if (!has_list_ && has_offsets_)
      throw Input_error(place_.file(), "offsets",
                        "expected curves, found a result of `offset`: its DXF, by --format dxf, can be read");
    if (!has_list_) records_.push_back(document_.finish(place_.file(), "", stem_));
    for (Curve_record& record : records_) record.y_is_down = document_.y_is_down();
    Curve_file file;
    file.curves = std::move(records_);
    file.unit_in_mm = document_.unit_in_mm();
    return file;
  }

 private:
  struct Level {
    Json_role role;
    bool fits;  // it is a list or an object as its role asks for; what is in others plays no part
  };

  [[nodiscard]] Json_role next_role() const {
    if (levels_.empty()) return Json_role::DOCUMENT;
    if (!levels_.back().fits) return Json_role::IGNORED;
    switch (levels_.back().role) {
      case Json_role::DOCUMENT:
        return place_.key() == "curves" ? Json_role::CURVES : role_in_curve(place_.key());
      case Json_role::CURVE:
        return role_in_curve(place_.key());
      case Json_role::CURVES:
        return Json_role::CURVE;
      case Json_role::POINTS:
        return Json_role::POINT;
      case Json_role::POINT:
        return Json_role::COORDINATE;
      case Json_role::WEIGHTS:
        return Json_role::WEIGHT;
      case Json_role::KNOTS:
        return Json_role::KNOT;
      case Json_role::PART:
        return Json_role::PARAMETER;
      case Json_role::PIECES:
        return Json_role::PIECE;
      case Json_role::PIECE:
        return role_in_piece(place_.key());
      default:
        return Json_role::IGNORED;
    }
  }

  static bool is_object(Json_role role) {
    return role == Json_role::DOCUMENT || role == Json_role::CURVE || role == Json_role::PIECE;
  }
  static bool is_list(Json_role role) {
    return role == Json_role::CURVES || role == Json_role::POINTS || role == Json_role::POINT ||
           role == Json_role::WEIGHTS || role == Json_role::KNOTS || role == Json_role::PIECES ||
           role == Json_role::PART;
  }

  Json_curve& curve() { return in_list_ ? member_ : document_; }

  bool scalar(const json& value) {
    const Json_role role = next_role();
    if (const char* const wanted = curve().take(role, value)) unexpected(role, wanted, shown(value));
    place_.pass();
    return true;
  }

  bool open(bool list) {
    const Json_role role = next_role();
    place_.open(list);
    levels_.push_back({role, list ? is_list(role) : is_object(role)});
    if (role == Json_role::CURVE && !list) {
      member_ = Json_curve();
      in_list_ = true;
    }
    if (levels_.back().fits) curve().begin(role);
    return true;
  }

  bool close(bool list) {
    const auto [role, fits] = levels_.back();
    const std::size_t count = place_.close();
    levels_.pop_back();
    const char* const wanted = fits ? curve().end(role, count) : curve().take(role, json());
    if (wanted != nullptr) unexpected(role, wanted, list ? "a list of " + std::to_string(count) : "an object");
    if (fits && role == Json_role::CURVE) end_member();
    place_.pass();
    return true;
  }

  void end_member() {
    const std::string name = stem_ + '.' + std::to_string(records_.size() + 1);
    records_.push_back(member_.finish(place_.file(), place_.path(), name));
    in_list_ = false;
  }

  void unexpected(Json_role role, const char* wanted, const std::string& found) {
    const bool is_of_list = role == Json_role::CURVES || role == Json_role::CURVE ||
                            (levels_.size() == 1 && (role == Json_role::UNIT || role == Json_role::Y_IS_DOWN));
    if (!is_of_list && curve().has_failed()) return;  // a message for each of a million wrong points takes its time
    const Input_error error(place_.file(), place_.path(), std::string("expected ") + wanted + ", found " + found);
    if (is_of_list) throw error;
    curve().fail(error);
  }

  const std::string &text_, &stem_;
  Json_place place_;
  std::vector<Level> levels_;
  Json_curve document_;  // the curve that the document itself is unless it has "curves"
  Json_curve member_;    // the current one of those
  bool has_list_ = false, has_offsets_ = false, in_list_ = false;
  std::vector<Curve_record> records_;
};

}  // namespace

Curve_file read_json_curves(const std::string& text, const std::string& file, const std::string& stem) {
  Json_reader reader(text, file, stem);
  json::sax_parse(text, &reader);
  return reader.result();
}

}  // namespace bounding_arcs_tool
