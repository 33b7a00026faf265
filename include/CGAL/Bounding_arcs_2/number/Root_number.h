// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers with square roots, the last resort where roots meet a type that has none: CORE::Expr behind a pointer,
// as its header takes longer to compile than a hierarchy.  With the compiled library no user's program reads it.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_ROOT_NUMBER_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_ROOT_NUMBER_H

#include <CGAL/Bounding_arcs_2/number/convert.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Real_embeddable_traits.h>

#include <memory>
#include <sstream>
#include <string>
#include <utility>

namespace CORE {
class Expr;
}

namespace CGAL::Bounding_arcs {

/// A number that does not change once it is made; copies share it.
/// \tparam Expression CORE::Expr, complete only where its members are: src/library/number/Root_number.cpp
template <class Expression> class Basic_root_number {
 public:
  Basic_root_number(int value = 0);      // NOLINT: integers are exact
  Basic_root_number(double value);       // NOLINT: and so are doubles
  Basic_root_number(long double value);  // NOLINT: no more bits than two doubles have
  /// A rational as its library writes it.
  explicit Basic_root_number(const std::string& rational);

  [[nodiscard]] const Expression& expression() const { return *value_; }
  [[nodiscard]] int compare(const Basic_root_number& other) const;  ///< -1, 0 or +1
  [[nodiscard]] Basic_root_number square_root() const;
  [[nodiscard]] double to_double() const;
  [[nodiscard]] std::pair<double, double> to_interval() const;

  Basic_root_number& operator+=(const Basic_root_number& other);
  Basic_root_number& operator-=(const Basic_root_number& other);
  Basic_root_number& operator*=(const Basic_root_number& other);
  Basic_root_number& operator/=(const Basic_root_number& other);
  Basic_root_number operator-() const;

  friend Basic_root_number operator+(Basic_root_number a, const Basic_root_number& b) { return a += b; }
  friend Basic_root_number operator-(Basic_root_number a, const Basic_root_number& b) { return a -= b; }
  friend Basic_root_number operator*(Basic_root_number a, const Basic_root_number& b) { return a *= b; }
  friend Basic_root_number operator/(Basic_root_number a, const Basic_root_number& b) { return a /= b; }
  friend Basic_root_number sqrt(const Basic_root_number& a) { return a.square_root(); }
  friend Basic_root_number abs(const Basic_root_number& a) { return a < Basic_root_number(0) ? -a : a; }
  friend bool operator<(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) < 0; }
  friend bool operator>(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) > 0; }
  friend bool operator<=(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) <= 0; }
  friend bool operator>=(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) >= 0; }
  friend bool operator==(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) == 0; }
  friend bool operator!=(const Basic_root_number& a, const Basic_root_number& b) { return a.compare(b) != 0; }

 private:
  explicit Basic_root_number(Expression&& value);

  std::shared_ptr<const Expression> value_;
};

using Root_number = Basic_root_number<CORE::Expr>;

namespace internal {
/// The number x, without a rounding.
template <class Rational> [[nodiscard]] Root_number to_root(const Rational& x) {
  std::ostringstream text;
  text << x;
  return Root_number(text.str());
}
template <class ET> [[nodiscard]] Root_number to_root(const CGAL::Lazy_exact_nt<ET>& x) { return to_root(x.exact()); }
[[nodiscard]] inline Root_number to_root(double x) { return Root_number(x); }
[[nodiscard]] inline Root_number to_root(long double x) { return Root_number(x); }
}  // namespace internal

/// Converts to exact numbers with square roots.
template <> struct internal::Converter<Root_number> {
  template <class Source> Root_number operator()(const Source& x) const { return internal::to_root(x); }
};

/// For programs that read CORE's header themselves.
template <> struct internal::Converter<CORE::Expr> {
  template <class Source> auto operator()(const Source& x) const { return internal::to_root(x).expression(); }
};

}  // namespace CGAL::Bounding_arcs

namespace CGAL {

/// Tells CGAL that these numbers are a field with square roots.
template <class Expression>
class Algebraic_structure_traits<Bounding_arcs::Basic_root_number<Expression>>
    : public Algebraic_structure_traits_base<Bounding_arcs::Basic_root_number<Expression>, Field_with_sqrt_tag> {
 public:
  using Type = Bounding_arcs::Basic_root_number<Expression>;
  using Is_exact = Tag_true;
  using Is_numerical_sensitive = Tag_true;
  /// The square root.
  struct Sqrt {
    using argument_type = Type;
    using result_type = Type;
    Type operator()(const Type& x) const { return sqrt(x); }
  };
};

/// Tells CGAL what doubles are next to such a number.
template <class Expression>
class Real_embeddable_traits<Bounding_arcs::Basic_root_number<Expression>>
    : public INTERN_RET::Real_embeddable_traits_base<Bounding_arcs::Basic_root_number<Expression>, Tag_true> {
 public:
  using Type = Bounding_arcs::Basic_root_number<Expression>;
  /// A double near a number.
  struct To_double {
    using argument_type = Type;
    using result_type = double;
    double operator()(const Type& x) const { return x.to_double(); }
  };
  /// Two doubles with a number between them.
  struct To_interval {
    using argument_type = Type;
    using result_type = std::pair<double, double>;
    std::pair<double, double> operator()(const Type& x) const { return x.to_interval(); }
  };
};

}  // namespace CGAL

#endif
