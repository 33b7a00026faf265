// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one place that knows what the CGAL version at hand takes and hands out: boost::variant in 5, std::variant in 6,
// and there sometimes what would be in it.

#ifndef CGAL_BOUNDING_ARCS_2_REGION_VARIANT_H
#define CGAL_BOUNDING_ARCS_2_REGION_VARIANT_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <CGAL/version.h>

#include <optional>
#include <type_traits>

#if CGAL_VERSION_MAJOR >= 6
#include <variant>
#else
#include <boost/variant.hpp>
#endif

namespace CGAL::Bounding_arcs {

/// The variant of CGAL's interfaces.
#if CGAL_VERSION_MAJOR >= 6
template <class... Ts> using Variant = std::variant<Ts...>;
#else
template <class T, class... Ts> using Variant = boost::variant<T, Ts...>;
#endif

/// \return nullptr if the variant holds something else
#if CGAL_VERSION_MAJOR >= 6
template <class T, class... Ts> [[nodiscard]] const T* get_if(const std::variant<Ts...>& v) {
  return std::get_if<T>(&v);
}
template <class T, class Value> [[nodiscard]] const T* get_if(const Value& v) {
  if constexpr (std::is_same_v<T, Value>) return &v;
  else return nullptr;
}
#else
template <class T, class Variant> [[nodiscard]] const T* get_if(const Variant& v) { return boost::get<T>(&v); }
#endif

namespace internal {
/// A value of a variant as CGAL's algorithms collect it: a variant in CGAL 5, which may be made a CGAL::Object, and the
/// value itself in CGAL 6, whose variants are of points of its own.
template <class Variant, class T> [[nodiscard]] auto as_result(const T& value) {
#if CGAL_VERSION_MAJOR >= 6
  return value;
#else
  return Variant(value);
#endif
}
}  // namespace internal

/// What is handed out as a T, which may itself be a variant of it; nothing if it is something else.
template <class T, class Value> [[nodiscard]] std::optional<T> value_as(const Value& v) {
  if constexpr (std::is_constructible_v<T, const Value&>) return T(v);
  else if (const T* held = get_if<T>(v)) return *held;
  return std::nullopt;
}

}  // namespace CGAL::Bounding_arcs

#endif
