// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Counts what a drawing has and the reader leaves out.

#ifndef BOUNDING_ARCS_TOOL_SVG_NOTES_H
#define BOUNDING_ARCS_TOOL_SVG_NOTES_H

#include <CGAL/Bounding_arcs_2/curve/Curve_file.h>

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace bounding_arcs_tool {

/// Notes by kind and reason, in the order in which their first ones came. What a use element repeats counts each time.
class Svg_notes {
 public:
  /// Whether what a note is about was left out, or read otherwise than it stands there.
  enum Outcome { LEFT_OUT, READ };

  void add(std::string_view what, std::string_view reason, Outcome outcome = LEFT_OUT) {
    add(what, reason, outcome, [] { return std::string(); });
  }

  /// \param detail is called for the first of its kind and reason alone, and says more of that one
  template <class Detail>
  void add(std::string_view what, std::string_view reason, Outcome outcome, const Detail& detail) {
    std::size_t& place = places_[{std::string(what), std::string(reason)}];
    if (place == 0) {
      Entry& entry = notes_.emplace_back();
      entry.note.what = what;
      entry.note.reason = reason;
      entry.note.is_read = outcome == READ;
      entry.first = detail();
      place = notes_.size();
    }
    ++notes_[place - 1].note.count;
  }

  [[nodiscard]] std::vector<CGAL::Bounding_arcs::Curve_file::Note> notes() const;

 private:
  struct Entry {
    CGAL::Bounding_arcs::Curve_file::Note note;
    std::string first;  // what is said of the first one
  };
  std::vector<Entry> notes_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // in notes_, from 1
};

}  // namespace bounding_arcs_tool

#endif
