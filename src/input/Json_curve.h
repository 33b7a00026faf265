// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve in the making while its JSON object is read, its keys in any order.
// Invariant: only what becomes part of the record is kept, so that memory is that of the record.

#ifndef BOUNDING_ARCS_TOOL_JSON_CURVE_H
#define BOUNDING_ARCS_TOOL_JSON_CURVE_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <nlohmann/json.hpp>

#include <array>
#include <optional>
#include <string>

namespace bounding_arcs_tool {

using CGAL::Bounding_arcs::Curve_record;
using CGAL::Bounding_arcs::Input_error;

/// What a value of a document is there for.
enum class Json_role {
  DOCUMENT,
  CURVES,  ///< the list of several
  CURVE,
  TYPE,
  NAME,
  LAYER,
  COLOUR,
  UNIT,  ///< of the document, and so is the next one
  Y_IS_DOWN,
  DEGREE,
  CLOSED,
  PERIODIC,
  POINTS,
  POINT,
  COORDINATE,
  WEIGHTS,
  WEIGHT,
  KNOTS,
  KNOT,
  PART,  ///< of a bezier, two parameters
  PARAMETER,
  DELTA,   ///< of a member of a family
  PIECES,  ///< of a path
  PIECE,
  IGNORED
};

/// The role of what stands under a key of a curve.
[[nodiscard]] Json_role role_in_curve(const std::string& key);
/// Returns the role of what stands under a key of a path's piece.
[[nodiscard]] Json_role role_in_piece(const std::string& key);

class Json_curve {
 public:
  /// Starts a list of the curve, or a point in it.
  void begin(Json_role list);
  /// Ends one of `count` values.
  /// \return what should have stood there, or nullptr
  [[nodiscard]] const char* end(Json_role list, std::size_t count);
  /// Takes a value that is neither a list nor an object.
  /// \return what should have stood there, or nullptr
  [[nodiscard]] const char* take(Json_role role, const nlohmann::json& value);

  /// Keeps the first thing that is wrong with the curve for finish(): the object that the document is turns out to be
  /// no curve where it has "curves".
  void fail(const Input_error& error) {
    if (!error_) error_.emplace(error);
  }
  [[nodiscard]] bool has_failed() const { return error_.has_value(); }

  /// What a document tells of all its curves.
  [[nodiscard]] double unit_in_mm() const { return unit_in_mm_; }
  [[nodiscard]] bool y_is_down() const { return record_.y_is_down; }

  /// The record, once.
  /// \param path the place of the curve, "" for the whole document
  /// \throws Input_error
  [[nodiscard]] Curve_record finish(const std::string& file, const std::string& path, const std::string& default_name);

 private:
  struct Complaint {
    std::string key, reason;  // key is empty for the curve as a whole
  };

  [[nodiscard]] Complaint complaint() const;
  [[nodiscard]] const char* add_piece();
  [[nodiscard]] bool has(Json_role role) const { return (given_ >> static_cast<unsigned>(role) & 1) != 0; }

  Curve_record record_;
  double unit_in_mm_ = 0;
  unsigned given_ = 0;  // a bit a role
  bool is_in_piece_ = false, has_own_points_ = false;
  std::array<double, 2> xy_{};
  std::size_t coordinates_ = 0;  // so far, of the current point
  std::optional<Input_error> error_;
};

}  // namespace bounding_arcs_tool

#endif
