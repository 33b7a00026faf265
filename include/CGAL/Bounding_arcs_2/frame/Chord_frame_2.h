// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The chord frame: all that a bounding region needs to know of a spiral segment, and the one thing that passes from
// curves to regions.  It holds no square root, so it is exact over any field.
//
//            ___---  p1 --> tangent1         alpha0 = angle(tangent0 -> chord)
//       _--       .                          alpha1 = angle(chord -> tangent1)
//     /    .  chord                          K_i    = kappa_i |chord| / 2
//   p0 --> tangent0

#ifndef CGAL_BOUNDING_ARCS_2_FRAME_CHORD_FRAME_2_H
#define CGAL_BOUNDING_ARCS_2_FRAME_CHORD_FRAME_2_H

#include <CGAL/Bounding_arcs_2/curve/Bezier_curve_2.h>
#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <vector>

namespace CGAL::Bounding_arcs {

template <class NT> struct Chord_angles_2;
template <class NT> struct Chord_frame_2;

/// A spiral segment up to its place, in units of `unit`; vectors keep their direction, tangents have any length.
/// With c = |chord|, n_i = |tangent_i|:
///   sin alpha0 = cross0 / (n0 c), sin alpha1 = cross1 / (n1 c), K_i = curvature_i c / n_i^3,
///   K0 - sin alpha0 = kneser0 / (n0^3 c), sin alpha1 - K1 = kneser1 / (n1^3 c).
/// For a spiral kneser0 and kneser1 have the same sign (Kneser 1912).
template <class NT> struct Chord_shape_2 {
  Xy<NT> chord, tangent0, tangent1;
  Xy<NT> tangent_change;    ///< tangent1 - tangent0, formed without cancellation
  NT cross0{0}, cross1{0};  ///< cross(tangent0, chord), cross(chord, tangent1)
  NT cross_change{0};       ///< cross0 - cross1, formed without cancellation
  NT square_change{0};      ///< (cross0^2 n1^2 - cross1^2 n0^2) / (cross0 + cross1), 0 where that sum is 0
  NT sine_change{0};        ///< n0 n1 c^2 sin(alpha0 - alpha1); both formed without cancellation
  NT curvature0{0}, curvature1{0}, kneser0{0}, kneser1{0};
  bool infinite0 = false, infinite1 = false;  ///< the end's curvature is infinite; curvature_i and kneser_i are 0
  NT unit{1};                                 ///< one unit of the vectors above, as a length of the plane
  std::vector<Xy<NT>> control_points;         ///< of the piece, relative to p0, where a construction asks for them
  std::vector<NT> weights;                    ///< of these, up to a positive factor; empty for a polynomial piece
  int turn = 0;                               ///< +1 left, -1 right, 0 straight
  bool turns_one_way = false;                 ///< cross0 and cross1 have one sign, not 0
  bool runs_ahead =
      true;  ///< both end tangents have a part along the chord, as those of a spiral cut where x' or y' = 0
  bool tight_first = true;  ///< |alpha0| >= |alpha1|: the start is the end of larger |curvature|
  bool proper = false;  ///< strictly a spiral as far as its ends tell: it runs ahead, and both Kneser differences have
                        ///< the sign that turn and tight end ask for (false for arcs, lines and slivers past a vertex)

  /// The shape with its start in the origin.
  [[nodiscard]] Chord_frame_2<NT> at_origin() const { return {{}, unit * chord, *this}; }

  /// The angles between chord and end tangents. Needs square roots.
  /// \guarantee over double, relative error of a few u in each member, of bulge_change up to the slope of curvature
  /// \source design formula: A d1 - B d0 = (A - B) d1 + B (d1 - d0), d_i = n_i c + T_i . D
  [[nodiscard]] Chord_angles_2<NT> angles() const {
    Chord_angles_2<NT> g;
    g.length0 = square_root(dot(tangent0, tangent0));
    g.length1 = square_root(dot(tangent1, tangent1));
    g.chord = square_root(dot(chord, chord));
    if (g.chord == NT(0)) return g;  // a single point
    const NT d0 = g.length0 * g.chord + dot(tangent0, chord), d1 = g.length1 * g.chord + dot(tangent1, chord);
    g.bulge0 = cross0 / d0;
    g.bulge1 = cross1 / d1;
    g.bulge_change = bulge_change(g.length0, g.length1, g.chord) / (d0 * d1);
    return g;
  }
  /// (tan(alpha0/2) - tan(alpha1/2)) d0 d1 = A d1 - B d0 with d_i = n_i c + T_i.D: c (A n1 - B n0) + (A T1.D - B T0.D).
  /// Where both angles turn the same way A n1 - B n0 = (A^2 n1^2 - B^2 n0^2) / (A n1 + B n0), and the two terms have
  /// the same sign, as sin(alpha0 - alpha1) has that of sin^2 alpha0 - sin^2 alpha1; else nothing cancels in the first
  /// place.
  [[nodiscard]] NT bulge_change(const NT& n0, const NT& n1, const NT& c) const {
    const NT first = cross0 * n1, second = cross1 * n0;
    if (!turns_one_way) return NT(c * (first - second) + sine_change);
    return NT(c * square_change * ((cross0 + cross1) / (first + second)) + sine_change);
  }

  /// Converts to another number type; the signs that were decided stay as they are.
  /// \param number converts one number
  template <class Target, class Convert> [[nodiscard]] Chord_shape_2<Target> over(const Convert& number) const {
    const auto vector = [&](const Xy<NT>& v) { return Xy<Target>{number(v.x), number(v.y)}; };
    std::vector<Xy<Target>> points;
    for (const Xy<NT>& q : control_points) points.push_back(vector(q));
    std::vector<Target> of_points;
    for (const NT& w : weights) of_points.push_back(number(w));
    return {vector(chord),
            vector(tangent0),
            vector(tangent1),
            vector(tangent_change),
            number(cross0),
            number(cross1),
            number(cross_change),
            number(square_change),
            number(sine_change),
            number(curvature0),
            number(curvature1),
            number(kneser0),
            number(kneser1),
            infinite0,
            infinite1,
            number(unit),
            points,
            of_points,
            turn,
            turns_one_way,
            runs_ahead,
            tight_first,
            proper};
  }
  template <class Target> [[nodiscard]] Chord_shape_2<Target> over() const {
    return over<Target>([](const NT& x) { return convert<Target>(x); });
  }
};

/// A chord shape at its place in the plane.
/// \code
/// const Bezier_spiral_2<double> spiral = spiral_segments(curve).front();
/// const Chord_frame_2<double> frame = spiral.frame<double>(spiral.first(), spiral.last());
/// const double thickness = Bca().thickness(frame.shape);
/// \endcode
template <class NT> struct Chord_frame_2 {
  Xy<NT> p0, p1;
  Chord_shape_2<NT> shape;

  /// Converts to another number type, likewise.
  template <class Target> [[nodiscard]] Chord_frame_2<Target> over() const {
    return {convert<Target>(p0), convert<Target>(p1), shape.template over<Target>()};
  }
};

namespace internal {
/// Sets the changes of squares and sines, `turn`, `tight_first` and `proper` from the other members:
/// A^2 n1^2 - B^2 n0^2 = (A - B)(A + B) n1^2 + B^2 (n1^2 - n0^2),  A T1.D - B T0.D = (A - B) T1.D + B (T1 - T0).D.
/// The first is kept over A + B, so that it is of third order in a flat piece's height and not of fourth.
template <class NT> void orient(Chord_shape_2<NT>& f) {
  const NT sum = f.cross0 + f.cross1;
  f.turn = sign_of(sum);
  f.square_change = NT(0);
  if (f.turn != 0)
    f.square_change = f.cross_change * dot(f.tangent1, f.tangent1) +
                      f.cross1 / sum * f.cross1 * dot(f.tangent_change, NT(2) * f.tangent0 + f.tangent_change);
  f.sine_change = f.cross_change * dot(f.tangent1, f.chord) + f.cross1 * dot(f.tangent_change, f.chord);
  f.turns_one_way = sign_of(f.cross0) * sign_of(f.cross1) > 0;
  f.runs_ahead = sign_of(dot(f.tangent0, f.chord)) > 0 && sign_of(dot(f.tangent1, f.chord)) > 0;
  f.tight_first = sign_of(f.square_change) * f.turn >= 0;
  const int expected = f.tight_first ? f.turn : -f.turn;
  const bool flat_end_infinite = f.tight_first ? f.infinite1 : f.infinite0;
  f.proper = f.runs_ahead && expected != 0 && !flat_end_infinite && (f.infinite0 || sign_of(f.kneser0) == expected) &&
             (f.infinite1 || sign_of(f.kneser1) == expected);
}
}  // namespace internal

/// The frame of any curve piece from its two end jets.
/// \guarantee exact over a field; over floating types the differences cancel for short or flat pieces, which
///   `bezier_chord_shape` avoids for Bezier curves
/// \pre both first derivatives are nonzero
template <class NT> [[nodiscard]] Chord_frame_2<NT> chord_frame(const End_jet_2<NT>& j0, const End_jet_2<NT>& j1) {
  Chord_frame_2<NT> frame{j0.point, j1.point, {}};
  Chord_shape_2<NT>& f = frame.shape;
  f.chord = j1.point - j0.point;
  f.tangent0 = j0.first;
  f.tangent1 = j1.first;
  f.tangent_change = j1.first - j0.first;
  f.cross0 = cross(f.tangent0, f.chord);
  f.cross1 = cross(f.chord, f.tangent1);
  f.cross_change = f.cross0 - f.cross1;
  const NT cc = dot(f.chord, f.chord);
  f.curvature0 = cross(j0.first, j0.second) / NT(2);
  f.curvature1 = cross(j1.first, j1.second) / NT(2);
  f.kneser0 = f.curvature0 * cc - f.cross0 * dot(f.tangent0, f.tangent0);
  f.kneser1 = f.cross1 * dot(f.tangent1, f.tangent1) - f.curvature1 * cc;
  internal::orient(f);
  return frame;
}

/// The half-angle tangents of a chord shape: bulge_i = tan(alpha_i / 2).
template <class NT> struct Chord_angles_2 {
  NT length0{0}, length1{0};  ///< |tangent0|, |tangent1| in the shape's units
  NT chord{0};                ///< |chord| in the shape's units
  NT bulge0{0}, bulge1{0};
  NT bulge_change{0};  ///< bulge0 - bulge1, formed without cancellation
};

}  // namespace CGAL::Bounding_arcs

#endif
