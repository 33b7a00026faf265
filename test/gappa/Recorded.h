// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A number that records what is done with it. Formulas of the library run with it as with any other number type, so
// that what Gappa proves is what the library computes.

#ifndef BOUNDING_ARCS_TEST_RECORDED_H
#define BOUNDING_ARCS_TEST_RECORDED_H

#include "Recording.h"

#include <boost/config.hpp>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace bounding_arcs_test {

/// A double that is an input, a result or, without a recording, a constant. Comparisons and signs go by its value: they
/// choose the path that is recorded.
class Recorded {
 public:
  Recorded() = default;
  Recorded(double value) : value_(value) {}  // NOLINT: a constant
  Recorded(int value) : value_(value) {}     // NOLINT
  /// An input, as it is or as what an exact number was rounded to. \pre the recording outlives what is made of it
  Recorded(Recording& recording, const std::string& name, double value, bool is_exact)
      : Recorded(&recording, {Step::INPUT, name, {}, is_exact}, value) {}

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] bool is_constant() const { return recording_ == nullptr; }
  /// The name of the step, or a constant's digits.
  [[nodiscard]] std::string name() const {
    if (!is_constant()) return name_;
    char digits[32];
    std::snprintf(digits, sizeof digits, "%a", value_);
    return digits;
  }

  friend Recorded operator-(const Recorded& a) {
    if (a.is_constant()) return -a.value_;
    return {a.recording_, {Step::NEGATION, a.name_, {}, true}, -a.value_};
  }
  friend Recorded operator+(const Recorded& a, const Recorded& b) {
    if (a.is_constant() && a.value_ == 0) return b;
    return made(Step::SUM, a, b, false, a.value_ + b.value_);
  }
  friend Recorded operator-(const Recorded& a, const Recorded& b) {
    return made(Step::DIFFERENCE, a, b, false, a.value_ - b.value_);
  }
  friend Recorded operator*(const Recorded& a, const Recorded& b) {
    if (b.is_constant() && !a.is_constant()) return b * a;
    if (a.is_constant() && a.value_ == 1) return b;
    if (a.is_constant() && a.value_ == -1) return -b;
    return made(Step::PRODUCT, a, b, a.is_power_of_two(), a.value_ * b.value_);
  }
  friend Recorded operator/(const Recorded& a, const Recorded& b) {
    return made(Step::QUOTIENT, a, b, b.is_power_of_two(), a.value_ / b.value_);
  }
  friend Recorded sqrt(const Recorded& a) {
    return {a.recording_, {Step::ROOT, a.name_, {}, false}, std::sqrt(a.value_)};
  }
  friend Recorded abs(const Recorded& a) { return a.value_ < 0 ? -a : a; }
  friend Recorded fabs(const Recorded& a) { return abs(a); }
  friend Recorded max BOOST_PREVENT_MACRO_SUBSTITUTION(const Recorded& a, const Recorded& b) { return a < b ? b : a; }
  friend bool operator<(const Recorded& a, const Recorded& b) { return a.value_ < b.value_; }
  friend bool operator>(const Recorded& a, const Recorded& b) { return a.value_ > b.value_; }
  friend bool operator<=(const Recorded& a, const Recorded& b) { return a.value_ <= b.value_; }
  friend bool operator>=(const Recorded& a, const Recorded& b) { return a.value_ >= b.value_; }
  friend bool operator==(const Recorded& a, const Recorded& b) { return a.value_ == b.value_; }
  friend bool operator!=(const Recorded& a, const Recorded& b) { return a.value_ != b.value_; }

 private:
  Recorded(Recording* recording, const Step& step, double value) : recording_(recording), value_(value) {
    if (recording == nullptr) throw std::logic_error("an operation on constants is none of a formula");
    name_ = recording->add(step);
  }
  static Recorded made(Step::Kind kind, const Recorded& a, const Recorded& b, bool is_exact, double value) {
    return {a.is_constant() ? b.recording_ : a.recording_, {kind, a.name(), b.name(), is_exact}, value};
  }
  [[nodiscard]] bool is_power_of_two() const {
    int exponent = 0;
    return is_constant() && std::fabs(std::frexp(value_, &exponent)) == 0.5;
  }

  Recording* recording_ = nullptr;
  std::string name_;
  double value_ = 0;
};

using Recorded_results = std::vector<Recorded>;

}  // namespace bounding_arcs_test

#endif
