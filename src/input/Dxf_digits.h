// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// With how many digits a DXF file is written, and how far apart ends are that were one point before.

#ifndef BOUNDING_ARCS_TOOL_DXF_DIGITS_H
#define BOUNDING_ARCS_TOOL_DXF_DIGITS_H

#include "Dxf_groups.h"

#include <string_view>

namespace bounding_arcs_tool {

/// Digits behind the decimal point: those of the longest number are what the file has been rounded to.
class Dxf_digits {
 public:
  /// Counts those of an entity.
  void take(const Dxf_item& entity);
  /// How far apart two ends may be that were one point before lengths were rounded; 0 where the file has too few digits
  /// to tell, as those of whole millimeters.
  [[nodiscard]] double rounding() const;
  /// How far off each end of an entity may be by the digits of the file's angles: 0 but for an ARC or ELLIPSE.
  /// \param size see arc_size
  [[nodiscard]] double end_error(std::string_view kind, double size) const;

 private:
  int of_lengths_ = 0, of_degrees_ = 0, of_radians_ = 0;
};

/// The radius of an ARC, or a bound of the half axes of an ELLIPSE; 0 for other entities.
[[nodiscard]] double arc_size(const Dxf_item& entity);

/// Ten to the power of minus the digits behind the point that the longer one of two groups has: how far off the
/// difference of two angles may be. 0 for fewer than three digits, by which a part of a turn may be meant.
[[nodiscard]] double last_place_of_angles(const Dxf_item& item, int from, int to);

/// "0.50" has 2, "1.5e-05" 6, "10" none.
[[nodiscard]] int digits_behind_point(std::string_view number);

}  // namespace bounding_arcs_tool

#endif
