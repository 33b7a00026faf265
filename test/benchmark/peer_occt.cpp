// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "peer.h"

#include <Geom2dAPI_ExtremaCurveCurve.hxx>
#include <Geom2dAPI_InterCurveCurve.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2d_BSplineCurve.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt2d.hxx>

#include <memory>

namespace bounding_arcs_benchmark {
namespace {

constexpr int DEGREE = 3;

template <class Points> TColgp_Array1OfPnt2d poles(const Points& points) {
  TColgp_Array1OfPnt2d result(1, static_cast<int>(points.size()));
  int i = 0;
  for (const Point& p : points) result.SetValue(++i, gp_Pnt2d(p.x, p.y));
  return result;
}

Handle(Geom2d_Curve) b_spline(const Chain& chain) {
  const int n = static_cast<int>(chain.size());
  TColStd_Array1OfReal knots(1, n + 1);
  TColStd_Array1OfInteger multiplicities(1, n + 1);
  for (int i = 0; i <= n; ++i) {
    knots.SetValue(i + 1, i);
    multiplicities.SetValue(i + 1, i == 0 || i == n ? DEGREE + 1 : 1);
  }
  return new Geom2d_BSplineCurve(poles(b_spline_points(chain)), knots, multiplicities, DEGREE);
}

double intersections(const Handle(Geom2d_Curve) & a, const Handle(Geom2d_Curve) & b) {
  constexpr double RESOLUTION = 1e-9;
  const Geom2dAPI_InterCurveCurve found(a, b, RESOLUTION);
  return found.NbPoints() + found.NbSegments();
}

/// What a library throws is no answer.
template <class Ask> Answer caught(const Ask& ask) {
  return [=](std::size_t i) {
    try {
      return static_cast<double>(ask(i));
    } catch (const Standard_Failure&) {
      return NO_ANSWER;
    }
  };
}

}  // namespace

Peers occt_peers(const Peer_cases& cases) {
  const auto curves = std::make_shared<std::vector<Handle(Geom2d_Curve)>>();
  for (const Chain& chain : cases.curves) curves->push_back(b_spline(chain));
  const std::string name = "OpenCASCADE";
  return {{name, CLOSEST, caught([=, &cases](std::size_t i) {
             const auto& c = cases.closest[i];
             const Geom2dAPI_ProjectPointOnCurve found(gp_Pnt2d(c.point.x, c.point.y), (*curves)[c.curve]);
             return found.NbPoints() == 0 ? NO_ANSWER : found.LowerDistance();
           })},
          {name, CUBICS, caught([&cases](std::size_t i) {
             const Handle(Geom2d_Curve) a = new Geom2d_BezierCurve(poles(cases.cubics[i].a)),
                                        b = new Geom2d_BezierCurve(poles(cases.cubics[i].b));
             return intersections(a, b);
           })},
          {name, CURVES, caught([=, &cases](std::size_t i) {
             return intersections((*curves)[cases.crossing[i].a], (*curves)[cases.crossing[i].b]);
           })},
          {name, DISTANCE, caught([=, &cases](std::size_t i) {
             const auto &a = (*curves)[cases.apart[i].a], &b = (*curves)[cases.apart[i].b];
             const Geom2dAPI_ExtremaCurveCurve found(a, b, a->FirstParameter(), a->LastParameter(), b->FirstParameter(),
                                                     b->LastParameter());
             return found.NbExtrema() == 0 ? NO_ANSWER : found.LowerDistance();
           })}};
}

}  // namespace bounding_arcs_benchmark
