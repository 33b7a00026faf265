// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The grammar of path data.

#include "Svg_outline.h"
#include "Svg_scanner.h"

#include <cctype>

namespace bounding_arcs_tool {

namespace {

using Point = Xy<double>;

// Carries out one command after the other. Invariant: mirroring_ is the command, S, T or none, that
// would mirror reflected_ if it came next.
class Path_drawer {
 public:
  Path_drawer(std::string_view data, Svg_outline& outline) : scanner_(data), outline_(outline) {}

  void draw() {
    scanner_.skip_space();
    if (!scanner_.at_end() && scanner_.next() != 'M' && scanner_.next() != 'm')
      scanner_.expected("the command M or m to start with");
    try {
      while (!scanner_.at_end()) draw_command();
    } catch (Svg_error& error) {
      if (error.character == 0) error.character = scanner_.character();
      throw;
    }
  }

 private:
  // A letter and its arguments, once or, without the letter, several times.
  void draw_command() {
    char command = scanner_.next();
    if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(command) == std::string_view::npos || command == '\0')
      scanner_.expected("a path command");
    scanner_.accept(command);
    scanner_.skip_space();
    if (command == 'Z' || command == 'z') return close();
    bool again = true;
    while (again) {
      draw_once(command);
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
      const bool comma = scanner_.skip_separator();
      again = comma || scanner_.at_number();
    }
  }

  void draw_once(char command) {
    is_first_ = true;
    relative_ = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    const Point c = current();
    const Point mirrored = kind == mirroring_ ? Point{2 * c.x - reflected_.x, 2 * c.y - reflected_.y} : c;
    mirroring_ = '\0';
    switch (kind) {
      case 'M':
        outline_.move_to(point());
        break;
      case 'L':
        outline_.line_to(point());
        break;
      case 'H':
        outline_.line_to({coordinate(current().x), current().y});
        break;
      case 'V':
        outline_.line_to({current().x, coordinate(current().y)});
        break;
      case 'C':
        return cubic(point());
      case 'S':
        return cubic(mirrored);
      case 'Q':
        return quadratic(point());
      case 'T':
        return quadratic(mirrored);
      default:
        arc();
    }
  }

  void cubic(const Point& p1) {
    const Point p2 = point(), p3 = point();
    outline_.curve_to({p1, p2, p3});
    mirror_for('S', p2);
  }

  void quadratic(const Point& p1) {
    outline_.curve_to({p1, point()});
    mirror_for('T', p1);
  }

  void arc() {
    Svg_arc arc{};
    arc.rx = argument();
    arc.ry = argument();
    arc.x_rotation = argument();
    scanner_.skip_separator();
    arc.large = scanner_.flag();
    scanner_.skip_separator();
    arc.sweep = scanner_.flag();
    outline_.arc_to(arc, point());
  }

  void close() {
    outline_.close();
    mirroring_ = '\0';
    scanner_.skip_space();
  }

  void mirror_for(char kind, const Point& p) {
    mirroring_ = kind;
    reflected_ = p;
  }

  [[nodiscard]] const Point& current() const { return outline_.current(); }

  double argument() {
    if (!is_first_) scanner_.skip_separator();
    is_first_ = false;
    return scanner_.number();
  }

  double coordinate(double base) { return argument() + (relative_ ? base : 0); }

  // Relative coordinates of all points of a command count from the current point before it.
  Point point() {
    const double x = coordinate(current().x);
    return {x, coordinate(current().y)};
  }

  Svg_scanner scanner_;
  Svg_outline& outline_;
  bool relative_ = false;
  bool is_first_ = true;  // no comma may come before the first argument
  char mirroring_ = '\0';
  Point reflected_;
};

}  // namespace

void draw_path_data(std::string_view data, Svg_outline& outline) { Path_drawer(data, outline).draw(); }

}  // namespace bounding_arcs_tool
