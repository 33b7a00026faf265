// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// DXF files as short texts, and what is read of an entity beside a line.

#ifndef BOUNDING_ARCS_TEST_DXF_TEXT_H
#define BOUNDING_ARCS_TEST_DXF_TEXT_H

#include "curve_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace bounding_arcs_test {

using CGAL::Bounding_arcs::Curve_file;
using CGAL::Bounding_arcs::Fill_rule;

// Groups are written with | between codes and values.
inline std::string lines(std::string text) {
  for (char& c : text)
    if (c == '|') c = '\n';
  return text;
}
inline std::string section(const std::string& name, const std::string& content) {
  return "0|SECTION|2|" + name + "|" + content + "0|ENDSEC|";
}
inline std::string dxf(const std::string& entities, const std::string& blocks = "", const std::string& tables = "") {
  return lines(section("TABLES", tables) + section("BLOCKS", blocks) + section("ENTITIES", entities) + "0|EOF|");
}
inline Curve_file read_text(const std::string& text, const Curve_file::Options& options = {}) {
  return CGAL::Bounding_arcs::Curve_file::from_text(text, "in.dxf", "in", options);
}
inline Curve_file read_entities(const std::string& entities, const std::string& blocks = "") {
  return read_text(dxf(entities, blocks));
}

// The length of all curves, by the chords of many parts.
inline double length_of(const Curve_file& file) {
  constexpr int PARTS = 4000;
  double length = 0;
  for (const Curve_record& record : file.curves)
    for (const Bezier& piece : record.beziers)
      for (int i = 0; i < PARTS; ++i) {
        const Point d = piece.point((i + 1.0) / PARTS) - piece.point(static_cast<double>(i) / PARTS);
        length += std::hypot(d.x, d.y);
      }
  return length;
}
inline std::string names_of(const Curve_file& file) {
  std::string names;
  for (const Curve_record& record : file.curves) names += (names.empty() ? "" : " ") + record.name;
  return names;
}

inline constexpr double PI = 3.14159265358979323846, NEAR = 1e-5;
inline const std::string LINE = "0|LINE|8|0|10|0|20|0|11|3|21|4|";  // of length 5
inline const std::string BESIDE = "0|LINE|8|beside|10|0|20|0|11|3|21|4|";
inline const std::string VERTEX = "0|VERTEX|8|0|";

// Reads as long a curve as is wanted, beside a line, and has notes.
inline void expect_length(double length, const std::string& entity, const std::string& notes = "") {
  const Curve_file file = read_entities(entity + BESIDE);
  EXPECT_NEAR(length_of(file), length + 5, NEAR) << entity;
  EXPECT_EQ(Curve_file::text_of(file.notes), notes) << entity;
  EXPECT_EQ(file.rule, Fill_rule::EVEN_ODD);
  for (const Curve_record& record : file.curves) expect_joined(record);
}
// Leaves an entity out, with a reason, and reads what is beside it.
inline void expect_left_out(const std::string& note, const std::string& entity, const std::string& blocks = "") {
  const Curve_file file = read_entities(entity + BESIDE, blocks);
  EXPECT_NEAR(length_of(file), 5, NEAR) << entity;
  EXPECT_EQ(Curve_file::text_of(file.notes), "left out: " + note) << entity;
  const std::string message = message_of([&] { (void)read_entities(entity, blocks); });
  EXPECT_EQ(message, "in.dxf: file: no curve in the drawing; left out: " + note);
}

}  // namespace bounding_arcs_test

#endif
