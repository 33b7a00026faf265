// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Curve files, JSON, SVG or DXF, as records of doubles, and the Bezier pieces of a record, or a drawing of all, over
// any number type. What reads is compiled: link Bounding_arcs::readers. The umbrella header leaves this one out.
// Invariant: a record that was read is valid, so that bezier_pieces() throws on none; its numbers are finite and its
// name is valid UTF-8, which may hold control characters.

#ifndef CGAL_BOUNDING_ARCS_2_CURVE_CURVE_FILE_H
#define CGAL_BOUNDING_ARCS_2_CURVE_CURVE_FILE_H

#include <CGAL/Bounding_arcs_2/curve/B_spline_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/curve/Drawing_2.h>
#include <CGAL/Bounding_arcs_2/curve/Fill_rule.h>
#include <CGAL/Bounding_arcs_2/curve/join_curves.h>
#include <CGAL/Bounding_arcs_2/number/Xy.h>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Bounding_arcs {

/// What is wrong with an input file; `what()` is the line "FILE: PLACE: REASON", in which control characters and bytes
/// that are not UTF-8 are written as `\xNN`.
/// \code
/// try {
///   const Drawing_2<double> drawing = read_drawing("shape.svg");
/// } catch (const Input_error& error) {
///   std::cerr << error.what() << '\n';
/// }
/// \endcode
struct Input_error : std::runtime_error {
  Input_error(const std::string& file, const std::string& place, const std::string& reason);
};

/// A curve as its file gives it.
/// \code
/// for (const Curve_record& record : read_curve_file("shape.svg").curves) std::cout << record.name << '\n';
/// \endcode
struct Curve_record {
  /// A colour as a DXF file has it: the number of one of AutoCAD's, any other one beside it, or none.
  struct Colour {
    int number = 0;  ///< 1 to 255, of which 7 is black on white and white on black; 0 for none
    int rgb = -1;    ///< 0xRRGGBB; -1 where the number tells all

    friend bool operator==(const Colour& a, const Colour& b) { return a.number == b.number && a.rgb == b.rgb; }
  };

  enum Type {
    BEZIER,   ///< degree + 1 control points
    BSPLINE,  ///< polynomial B-spline
    NURBS,    ///< B-spline with weights
    PATH      ///< a chain of Bezier curves of several degrees, a subpath of an SVG file or an entity of a DXF file
  };

  /// What an open curve has inside; of a closed one it tells nothing.
  enum Filling {
    NO_INSIDE,  ///< nothing
    CLOSED,     ///< the file fills it as if a straight line closed it: a subpath of an SVG shape
    UNKNOWN     ///< a style sheet, which is not read, may have the file fill it so or not
  };

  std::string name;   ///< need not be unique in a file
  std::string layer;  ///< of a DXF file, or of an SVG file from Inkscape, as it is spelled there; empty for none
  Colour colour;      ///< that is seen: of an entity or its layer, the stroke of a shape or else its fill
  Type type = BEZIER;
  int degree = 1;                          ///< of a path, the greatest of its pieces
  std::vector<Xy<double>> control_points;  ///< Euclidean, not multiplied by the weights; empty for a path
  std::vector<double> weights;
  std::vector<double> part;  ///< of a bezier: the two parameters of the part that a study is of, or none
  double delta = 0;  ///< the parameter of the family that the curve is a member of, above 0; 0 where there is none
  /// When periodic one period of control_points.size() + 1 knots, otherwise all of them; empty if uniform.
  std::vector<double> knots;
  bool uniform_knots = false;
  bool closed = false;  ///< what the file says; nothing is added to close a curve
  bool periodic = false;
  bool y_is_down = false;                       ///< y grows downwards, as in SVG files; to be known for pictures only
  std::vector<Bezier_curve_2<double>> beziers;  ///< of a path: neighbours share their end bit for bit
  Filling filling = NO_INSIDE;                  ///< see close_filled
  double end_error = 0;  ///< by how much farther than Curve_file::rounding tells its ends may be off, each of them: by
                         ///< the digits of the angles of a DXF file's arc

  /// The B-spline curve of a record of type BSPLINE or NURBS; uniform knots without periodicity are unclamped.
  /// \throws std::invalid_argument as B_spline_curve_2; not for a record that was read
  template <class NT> [[nodiscard]] B_spline_curve_2<NT> b_spline() const {
    auto points = internal::points_over<NT>(control_points);
    auto over = internal::numbers_over<NT>(weights);
    if (periodic)
      return B_spline_curve_2<NT>::periodic(degree, std::move(points), internal::numbers_over<NT>(knots),
                                            std::move(over));
    if (uniform_knots) return B_spline_curve_2<NT>::uniform(degree, std::move(points), std::move(over));
    return B_spline_curve_2<NT>(degree, std::move(points), internal::numbers_over<NT>(knots), std::move(over));
  }

  /// The Bezier pieces of a record in curve order.
  /// \guarantee neighbours share their end bit for bit; every double of the record is taken exactly if NT holds it
  template <class NT> [[nodiscard]] std::vector<Bezier_curve_2<NT>> bezier_pieces() const {
    std::vector<Bezier_curve_2<NT>> pieces;
    switch (type) {
      case BEZIER:
        pieces.emplace_back(internal::points_over<NT>(control_points), internal::numbers_over<NT>(weights));
        break;
      case PATH:
        for (const Bezier_curve_2<double>& piece : beziers) pieces.push_back(piece.over<NT>());
        break;
      case BSPLINE:
      case NURBS:
        pieces = b_spline<NT>().bezier_pieces();
        break;
    }
    return pieces;
  }
};

/// A file that was read: its curves, what its closed curves enclose, and what it has beside them.
/// \code
/// const Curve_file file = read_curve_file("part.dxf");
/// if (!file.notes.empty()) std::cerr << Curve_file::text_of(file.notes) << '\n';
/// const Bounding_arc_tree_2 tree(drawing<double>(file.curves));
/// Offset::Options options;
/// options.rule = file.rule;
/// const Offset inset = offset(tree, -0.1, 1e-4, options);
/// \endcode
struct Curve_file {
  /// Several things of one kind that a file has and the reader left out, or took otherwise than they stand there.
  struct Note {
    std::size_t count = 0;  ///< how many, at least 1
    std::string what;       ///< their kind in the singular, as the file calls it: "MTEXT", "text", "CIRCLE"
    std::string reason;     ///< why, in a clause: "has no curve", "on a layer that is off", "radius 0"
    bool is_read = false;   ///< they were read, otherwise than they stand there
  };

  /// What a reader takes of a drawing beside what a CAD program or browser shows of it.
  struct Options {
    bool with_hidden = false;  ///< entities that are invisible or not displayed, or on layers that are off or frozen
    bool with_paper = false;   ///< entities in paper space: frames and titles of sheets
    std::optional<Fill_rule> rule = {};  ///< what closed curves enclose, whatever the file says
    std::vector<std::string> layers =
        {};  ///< of DXF, in any case of letters: notes tell of these alone; of all if empty
  };

  /// The part of the plane that an SVG file shows, and how large.
  struct Page {
    double x = 0, y = 0, width = 0, height = 0;  ///< its viewBox, or what its width and height tell without one
    std::string view_box;                        ///< as the file has it; empty for none
    std::string shown_width, shown_height;       ///< its width and height, likewise
    std::string aspect_ratio;                    ///< its preserveAspectRatio, likewise
  };

  std::vector<Curve_record> curves;     ///< none only where a JSON file has an empty list of "curves"
  Fill_rule rule = Fill_rule::NONZERO;  ///< even-odd for DXF, whose curves have no direction that means anything;
                                        ///< the `fill-rule` of those shapes of an SVG file for which it matters;
                                        ///< else nonzero, or what the options ask for
  std::vector<Note> notes;              ///< what was left out, in a fixed order; empty where all was read
  double unit_in_mm = 0;                ///< the length of a unit of the coordinates; 0 where the file tells none
  double rounding = 0;  ///< how far ends may be apart that are the same but for the digits of a DXF or SVG file; 0 for
                        ///< JSON, whose curves are what its writer numbered
  std::optional<Page> page = {};  ///< of an SVG file that tells one

  /// Reads a text that is in memory, as read_curve_file reads a file.
  /// \param file what errors call the text
  /// \param stem the name of curves without one
  [[nodiscard]] static Curve_file from_text(const std::string& text, const std::string& file, const std::string& stem,
                                            const Options& options);
  [[nodiscard]] static Curve_file from_text(const std::string& text, const std::string& file, const std::string& stem) {
    return from_text(text, file, stem, Options());
  }

  /// A note as text: "2 MTEXT: no curve".
  [[nodiscard]] static std::string text_of(const Note& note);
  /// Notes in one line: "left out: 2 MTEXT: no curve; 1 CIRCLE: radius 0; read all the same: 1 file: no EOF".
  [[nodiscard]] static std::string text_of(const std::vector<Note>& notes);
};

/// Reads a file in JSON, SVG or DXF, told apart by how it begins.
/// \param path the file; "-" reads standard input
/// \throws Input_error when the file cannot be read, is not well-formed, or is a drawing without a curve
[[nodiscard]] Curve_file read_curve_file(const std::string& path, const Curve_file::Options& options = {});

/// Closes open curves that their file fills, each by a straight line behind its last piece, so that they have an inside
/// for Boolean operations, point location and others that need one. Curves themselves, for offsets or distances, are
/// open without that.
/// \code
/// Curve_file file = read_curve_file("icon.svg");
/// const std::size_t closed = close_filled(file.curves);
/// \endcode
/// \return how many were closed
std::size_t close_filled(std::vector<Curve_record>& records);

/// Joins open curves by join_curves: where exactly two ends meet, those of one layer first. A record that others are
/// joined to becomes a path. Ends may be as much farther apart as the records' own errors tell.
/// \code
/// Curve_file file = read_curve_file("part.dxf");
/// const Joined_curves joined = join_curves(file.curves, file.rounding);
/// \endcode
/// \param with_filled also those that their file fills, which have an inside of their own, see close_filled
/// \return the drawing of the records, and what was done
/// \throws std::invalid_argument for an eps that is no number or below 0
Joined_curves join_curves(std::vector<Curve_record>& records, double eps, bool with_filled = true);

/// The records as one drawing: curve i is record i, with its name. Parameters are the knots of a B-spline record, else
/// piece i is over [i, i + 1].
/// \guarantee as Curve_record::bezier_pieces; a curve is closed where its ends are the same over NT, whatever its file
///   says
template <class NT> [[nodiscard]] Drawing_2<NT> drawing(const std::vector<Curve_record>& records) {
  Drawing_2<NT> result;
  for (const Curve_record& record : records) {
    const bool has_knots = record.type == Curve_record::BSPLINE || record.type == Curve_record::NURBS;
    if (has_knots) result.add(record.b_spline<NT>(), record.name);
    else result.add(record.bezier_pieces<NT>(), record.name);
  }
  return result;
}

/// The drawing in a file. \throws Input_error as read_curve_file
[[nodiscard]] Drawing_2<double> read_drawing(const std::string& path);

}  // namespace CGAL::Bounding_arcs

#endif
