// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs as text, with the 17 digits that tell every double apart.

#ifndef BOUNDING_ARCS_LIBRARY_ARC_ARC_TEXT_H
#define BOUNDING_ARCS_LIBRARY_ARC_ARC_TEXT_H

#include <CGAL/Bounding_arcs_2/arc/Arc_2.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <optional>
#include <ostream>

namespace CGAL::Bounding_arcs {

/// Writes numbers with a space between two of them, whatever the stream's own precision and flags are.
class Arc_text {
 public:
  explicit Arc_text(std::ostream& out) : out_(out), flags_(out.flags()), precision_(out.precision(17)) {
    out.unsetf(std::ios_base::floatfield | std::ios_base::showpos | std::ios_base::showpoint);
  }
  Arc_text(const Arc_text&) = delete;
  Arc_text& operator=(const Arc_text&) = delete;
  ~Arc_text() {
    out_.precision(precision_);
    out_.flags(flags_);
  }

  Arc_text& operator<<(double x) {
    if (!is_first_) out_ << ' ';
    is_first_ = false;
    out_ << x;
    return *this;
  }
  Arc_text& operator<<(const Xy<double>& p) { return *this << p.x << p.y; }
  /// Writes an arc behind others, whose common points are written once.
  Arc_text& operator<<(const Arc_2& arc) {
    if (!end_) *this << arc.from;
    else if (*end_ != arc.from) mark(",") << arc.from;
    end_ = arc.to;
    return *this << arc.bulge << arc.to;
  }
  /// Writes a mark right behind the last number.
  Arc_text& mark(const char* text) {
    out_ << text;
    return *this;
  }
  /// Writes a mark in front of the next number.
  Arc_text& open(const char* text) {
    if (!is_first_) out_ << ' ';
    out_ << text;
    is_first_ = true;
    return *this;
  }

 private:
  std::ostream& out_;
  std::ios_base::fmtflags flags_;
  std::streamsize precision_;
  bool is_first_ = true;
  std::optional<Xy<double>> end_;
};

}  // namespace CGAL::Bounding_arcs

#endif
