// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one place that knows which variants the CGAL version at hand hands out: boost::variant in 5, std::variant in 6.

#ifndef CGAL_BOUNDING_ARCS_2_INTERNAL_VARIANT_H
#define CGAL_BOUNDING_ARCS_2_INTERNAL_VARIANT_H

#include <CGAL/version.h>

#if CGAL_VERSION_MAJOR >= 6
#include <variant>
#else
#include <boost/variant.hpp>
#endif

namespace CGAL::Bounding_arcs::internal {

/// \return nullptr if the variant holds something else
template <class T, class Variant> [[nodiscard]] const T* get_if(const Variant& v) {
#if CGAL_VERSION_MAJOR >= 6
  return std::get_if<T>(&v);
#else
  return boost::get<T>(&v);
#endif
}

}  // namespace CGAL::Bounding_arcs::internal

#endif
