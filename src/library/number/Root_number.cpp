// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The members of Root_number, which read all of CORE.

#include <CGAL/Bounding_arcs_2/number/Root_number.h>

#include <CGAL/CORE_Expr.h>

#include <memory>
#include <string>
#include <utility>

namespace CGAL::Bounding_arcs {

template <class Expression>
Basic_root_number<Expression>::Basic_root_number(Expression&& value)
    : value_(std::make_shared<const Expression>(std::move(value))) {}
template <class Expression>
Basic_root_number<Expression>::Basic_root_number(int value) : Basic_root_number(Expression(value)) {}
template <class Expression>
Basic_root_number<Expression>::Basic_root_number(double value) : Basic_root_number(Expression(value)) {}
template <class Expression> Basic_root_number<Expression>::Basic_root_number(long double value) {
  const double high = static_cast<double>(value);
  value_ = std::make_shared<const Expression>(Expression(high) +
                                              Expression(static_cast<double>(value - static_cast<long double>(high))));
}
template <class Expression>
Basic_root_number<Expression>::Basic_root_number(const std::string& rational)
    : Basic_root_number(Expression(CORE::BigRat(rational))) {}

template <class Expression> int Basic_root_number<Expression>::compare(const Basic_root_number& other) const {
  return value_->cmp(*other.value_);
}
template <class Expression> Basic_root_number<Expression> Basic_root_number<Expression>::square_root() const {
  return Basic_root_number(sqrt(*value_));
}
template <class Expression> double Basic_root_number<Expression>::to_double() const { return CGAL::to_double(*value_); }
template <class Expression> std::pair<double, double> Basic_root_number<Expression>::to_interval() const {
  return CGAL::to_interval(*value_);
}

template <class Expression>
Basic_root_number<Expression>& Basic_root_number<Expression>::operator+=(const Basic_root_number& other) {
  return *this = Basic_root_number(*value_ + *other.value_);
}
template <class Expression>
Basic_root_number<Expression>& Basic_root_number<Expression>::operator-=(const Basic_root_number& other) {
  return *this = Basic_root_number(*value_ - *other.value_);
}
template <class Expression>
Basic_root_number<Expression>& Basic_root_number<Expression>::operator*=(const Basic_root_number& other) {
  return *this = Basic_root_number(*value_ * *other.value_);
}
template <class Expression>
Basic_root_number<Expression>& Basic_root_number<Expression>::operator/=(const Basic_root_number& other) {
  return *this = Basic_root_number(*value_ / *other.value_);
}
template <class Expression> Basic_root_number<Expression> Basic_root_number<Expression>::operator-() const {
  return Basic_root_number(-*value_);
}

}  // namespace CGAL::Bounding_arcs

template class CGAL::Bounding_arcs::Basic_root_number<CORE::Expr>;
