// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers that carry error bounds, one operation at a time, against exact rationals: no error is larger than its bound,
// and each term of a bound is nearly used up by some operands, so that neither half of it nor twice as much would do.

#include <CGAL/Bounding_arcs_2/number/Bounded_double.h>
#include <CGAL/Bounding_arcs_2/number/Mpfr_interval.h>
#include "../../src/library/number/Pair.h"

#include <CGAL/Exact_rational.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

namespace test_bounded_arithmetic {
namespace {

using CGAL::Bounding_arcs::Bounded_double;
using CGAL::Bounding_arcs::HALF_ULP;
using CGAL::Bounding_arcs::Magnitude;
using Exact = CGAL::Exact_rational;

constexpr unsigned SEED = 811;
constexpr int SAMPLES = 4000;
constexpr double NEARLY = 0.95;  // the share of a bound that some error must exceed

enum class Operation { PLUS, MINUS, TIMES, OVER, ROOT };
constexpr Operation ALL_OPERATIONS[] = {Operation::PLUS, Operation::MINUS, Operation::TIMES, Operation::OVER,
                                        Operation::ROOT};
std::string name(Operation operation) {
  constexpr const char* NAMES[] = {"plus", "minus", "times", "over", "root"};
  return NAMES[static_cast<int>(operation)];
}

template <class NT> NT applied(Operation operation, const NT& a, const NT& b) {
  if (operation == Operation::PLUS) return NT(a + b);
  if (operation == Operation::MINUS) return NT(a - b);
  return operation == Operation::TIMES ? NT(a * b) : NT(a / b);
}
Bounded_double applied_to_bounded(Operation operation, const Bounded_double& a, const Bounded_double& b) {
  return operation == Operation::ROOT ? sqrt(a) : applied(operation, a, b);
}

// Whether |value - the operation's exact result| <= bound; roots are compared by their squares.
bool is_within(Operation operation, const Exact& x, const Exact& y, double value, const Exact& bound) {
  const Exact low = Exact(Exact(value) - bound), high = Exact(Exact(value) + bound);
  if (operation == Operation::ROOT) return high >= 0 && x <= high * high && (low <= 0 || low * low <= x);
  const Exact exact = applied(operation, x, y);
  return low <= exact && exact <= high;
}

// A number with an error bound, and a number that it may stand for.
struct Operand {
  Bounded_double bounded;
  Exact exact;
};

// What of a bound the operands make work.
enum class Source { ROUNDING, FIRST, SECOND, ALL };
constexpr Source ALL_SOURCES[] = {Source::ROUNDING, Source::FIRST, Source::SECOND, Source::ALL};

class Operands {
 public:
  explicit Operands(unsigned seed) : random_(seed) {}

  // Of any size and sign. Errors, if any, are 2^-40 to 2 times the value, and mostly as large as their bound allows.
  Operand make(bool has_error, bool is_positive) {
    const double size = std::exp2(60 * unit_(random_)) * (is_positive || random_() % 2 == 0 ? 1 : -1);
    if (!has_error) return {Bounded_double(size), Exact(size)};
    const double error = std::fabs(size) * std::exp2(-19.5 + 20.5 * unit_(random_));
    const int choice = static_cast<int>(random_() % 5);
    const Exact share = choice < 2 ? Exact(-1) : choice < 4 ? Exact(1) : Exact(unit_(random_));
    return {Bounded_double(size, error), Exact(Exact(size) + share * Exact(error))};
  }
  // Positive, with 0 as far off as its bound allows.
  Operand make_zero() {
    const double size = std::exp2(60 * unit_(random_));
    return {Bounded_double(size, size), Exact(0)};
  }
  // Slightly more than 1, so that half an ulp is all that a bound allows for rounding.
  Operand make_near_one() {
    const double value = 1 + std::ldexp(std::fabs(unit_(random_)), -8);
    return {Bounded_double(value), Exact(value)};
  }

  std::mt19937 random_;

 private:
  std::uniform_real_distribution<double> unit_{-1, 1};
};

struct Checked {
  int count = 0;
  bool is_nearly_used = false;
};

void expect_within_bound(Operation operation, const Operand& a, const Operand& b, Checked& checked) {
  if (operation == Operation::ROOT && a.exact < 0) return;
  const Bounded_double result = applied_to_bounded(operation, a.bounded, b.bounded);
  const double bound = result.error_bound();
  if (!(bound < std::numeric_limits<double>::infinity())) return;  // a divisor that may be 0
  ++checked.count;
  ASSERT_TRUE(is_within(operation, a.exact, b.exact, result.value(), Exact(bound)))
      << a.bounded.value() << " +- " << a.bounded.error_bound() << ", " << b.bounded.value() << " +- "
      << b.bounded.error_bound() << ": " << result.value() << " +- " << bound;
  if (!checked.is_nearly_used)
    checked.is_nearly_used = !is_within(operation, a.exact, b.exact, result.value(), Exact(NEARLY) * Exact(bound));
}

TEST(BoundedDouble, EveryOperationIsWithinItsBoundAndNearlyUsesIt) {
  for (const Operation operation : ALL_OPERATIONS)
    for (const Source source : ALL_SOURCES) {
      if (operation == Operation::ROOT && source == Source::SECOND) continue;
      SCOPED_TRACE(name(operation) + ", source " + std::to_string(static_cast<int>(source)));
      Operands operands(SEED);
      Checked checked;
      for (int i = 0; i < SAMPLES; ++i) {
        const bool is_root = operation == Operation::ROOT, is_rounding = source == Source::ROUNDING;
        const Operand a = is_rounding            ? operands.make_near_one()
                          : is_root && i % 4 < 2 ? operands.make_zero()
                                                 : operands.make(source != Source::SECOND, is_root && i % 4 == 2);
        Operand b = is_rounding ? operands.make_near_one() : operands.make(source != Source::FIRST, false);
        if (operation == Operation::MINUS) b = {-b.bounded, Exact(-b.exact)};
        ASSERT_NO_FATAL_FAILURE(expect_within_bound(operation, a, b, checked));
      }
      EXPECT_GT(checked.count, SAMPLES / 2);
      EXPECT_TRUE(checked.is_nearly_used);
    }
}

// Differences that cancel, where what is inherited is all of the error.
TEST(BoundedDouble, DifferencesKeepTheErrorsOfWhatCancels) {
  Operands operands(SEED + 1);
  Checked checked;
  for (int i = 0; i < SAMPLES; ++i) {
    const double value = operands.make(false, false).bounded.value(), error = std::ldexp(std::fabs(value), -30);
    const int sign = i % 2 == 0 ? 1 : -1;
    const Operand a{Bounded_double(value, error), Exact(value) + Exact(sign) * Exact(error)},
        b{Bounded_double(value, 2 * error), Exact(value) - Exact(2 * sign) * Exact(error)};
    ASSERT_NO_FATAL_FAILURE(expect_within_bound(Operation::MINUS, a, b, checked));
  }
  EXPECT_EQ(checked.count, SAMPLES);
  EXPECT_TRUE(checked.is_nearly_used);
}

TEST(BoundedDouble, BoundsWhatUnderflows) {
  const double denormal = std::numeric_limits<double>::denorm_min();
  const auto exact = [](double value) { return Operand{Bounded_double(value), Exact(value)}; };
  const auto inexact = [](double value, double error) {
    return Operand{Bounded_double(value, error), Exact(value) + Exact(error)};
  };
  Checked checked;
  expect_within_bound(Operation::TIMES, exact(0x1p-600), exact(0x1p-600), checked);    // to 0
  expect_within_bound(Operation::TIMES, exact(0x1.8p-537), exact(0x1p-537), checked);  // to a subnormal, rounded
  expect_within_bound(Operation::TIMES, exact(3 * denormal), exact(0.5), checked);     // a tie
  expect_within_bound(Operation::OVER, exact(0x1p-600), exact(0x1p600), checked);      // to 0
  expect_within_bound(Operation::OVER, exact(3 * denormal), exact(2.0), checked);      // a tie
  expect_within_bound(Operation::TIMES, inexact(0, 0x1p-600), inexact(0, 0x1p-600), checked);  // the bound itself
  expect_within_bound(Operation::TIMES, inexact(1, 0x1p-600), inexact(0x1p-500, 0x1p-560), checked);
  expect_within_bound(Operation::OVER, inexact(0x1p-1000, 0x1p-1040), inexact(0x1p100, 0x1.fffffp99), checked);
  EXPECT_EQ(checked.count, 8);
}

TEST(BoundedDouble, MakesNoPromiseOverADivisorThatMayBeZero) {
  for (const double error : {1.0, 1 - 0x1p-40, 2.0})
    EXPECT_EQ((Bounded_double(3.0) / Bounded_double(-1.0, error)).error_bound(),
              std::numeric_limits<double>::infinity());
  EXPECT_LT((Bounded_double(3.0) / Bounded_double(-1.0, 0.999)).error_bound(), 3001);
}

// Many terms: bounds are rounded down as often as up, which their slack makes up for.
TEST(BoundedDouble, SumsKeepTheirBoundsOverManyTerms) {
  std::mt19937 random(SEED + 2);
  std::uniform_real_distribution<double> unit(1, 2);
  for (int i = 0; i < 50; ++i) {
    Bounded_double sum;
    Exact least(0);  // what the bound must be without any error of its own
    for (int k = 0; k < 200; ++k) {
      const double error = unit(random);
      least += Exact(error);
      sum = sum + Bounded_double(0.0, error);
    }
    EXPECT_GE(Exact(sum.error_bound()), least);
    EXPECT_LE(Exact(sum.error_bound()), least * Exact(1 + 0x1p-27));
  }
}

TEST(BoundedDouble, LiesBetweenLowerAndUpper) {
  Operands operands(SEED + 5);
  for (int i = 0; i < SAMPLES; ++i) {
    const Operand a = operands.make(i % 4 != 0, false);
    ASSERT_LE(Exact(a.bounded.lower()), a.exact);
    ASSERT_GE(Exact(a.bounded.upper()), a.exact);
  }
  EXPECT_TRUE(certainly_less(Bounded_double(1.0, 0.25), Bounded_double(2.0, 0.5)));
  EXPECT_FALSE(certainly_less(Bounded_double(1.0, 0.5), Bounded_double(2.0, 0.5)));
}

TEST(BoundedDouble, TheLargerOfTwoMayHaveTheErrorOfTheSmaller) {
  Operands operands(SEED + 3);
  bool is_nearly_used = false;
  for (int i = 0; i < SAMPLES; ++i) {
    Operand a = operands.make(true, false), b = operands.make(true, false);
    const Bounded_double largest = max BOOST_PREVENT_MACRO_SUBSTITUTION(a.bounded, b.bounded), size = abs(a.bounded);
    const Exact error = CGAL::abs(Exact((a.exact < b.exact ? b.exact : a.exact) - Exact(largest.value())));
    ASSERT_LE(error, Exact(largest.error_bound()));
    ASSERT_LE(CGAL::abs(Exact(CGAL::abs(a.exact) - Exact(size.value()))), Exact(size.error_bound()));
    is_nearly_used = is_nearly_used || error > Exact(NEARLY) * Exact(largest.error_bound());
  }
  EXPECT_TRUE(is_nearly_used);
}

// A number as large as a magnitude allows, and what double arithmetic made of it.
struct Sized {
  Magnitude magnitude;
  double computed;
  Exact exact;
};

// One of the two has the magnitude's size, and they differ by its error; small errors, as large ones count in sizes.
Sized sized(Operands& operands, bool is_near_one, bool has_error) {
  const double size =
      is_near_one ? operands.make_near_one().bounded.value() : operands.make(false, true).bounded.value();
  if (!has_error) return {Magnitude(size, 0), size, Exact(size)};
  const double error =
      std::ldexp(size, -7 - static_cast<int>(operands.random_() % 30));  // a difference without rounding
  if (operands.random_() % 2 == 0) return {Magnitude(size, error / HALF_ULP), size, Exact(Exact(size) - Exact(error))};
  const double less = size - error;
  const Exact exact = (std::min)(Exact(size), Exact(Exact(less) + Exact(error)));
  return {Magnitude(size, error / HALF_ULP), less, exact};
}

void expect_within_bound(Operation operation, const Sized& a, const Sized& b, Checked& checked) {
  const Magnitude m = operation == Operation::PLUS    ? a.magnitude + b.magnitude
                      : operation == Operation::MINUS ? a.magnitude - b.magnitude
                                                      : a.magnitude * b.magnitude;
  const double computed = applied(operation, a.computed, b.computed);
  const Exact exact = applied(operation, a.exact, b.exact), error = CGAL::abs(Exact(Exact(computed) - exact));
  ++checked.count;
  ASSERT_LE(std::fabs(computed), m.size * Magnitude::SLACK);
  ASSERT_LE(CGAL::abs(exact), Exact(m.size * Magnitude::SLACK));
  ASSERT_LE(error, Exact(m.bound())) << a.computed << ' ' << name(operation) << ' ' << b.computed;
  checked.is_nearly_used = checked.is_nearly_used || error > Exact(NEARLY) * Exact(m.bound());
}

TEST(Magnitude, EveryOperationIsWithinItsBoundAndNearlyUsesIt) {
  for (const Operation operation : {Operation::PLUS, Operation::MINUS, Operation::TIMES})
    for (const Source source : ALL_SOURCES) {
      SCOPED_TRACE(name(operation) + ", source " + std::to_string(static_cast<int>(source)));
      Operands operands(SEED + 4);
      Checked checked;
      for (int i = 0; i < SAMPLES; ++i) {
        const bool is_rounding = source == Source::ROUNDING;
        const Sized a = sized(operands, is_rounding, source == Source::FIRST || source == Source::ALL);
        Sized b = sized(operands, is_rounding, source == Source::SECOND || source == Source::ALL);
        if (operation == Operation::MINUS) b = {b.magnitude, -b.computed, Exact(-b.exact)};
        ASSERT_NO_FATAL_FAILURE(expect_within_bound(operation, a, b, checked));
      }
      EXPECT_TRUE(checked.is_nearly_used);
    }
}

// What is held without an error has none, and a number's sign is no matter of its size.
TEST(Magnitude, OfADoubleIsItsSize) {
  EXPECT_EQ(Magnitude(-3.0).size, 3);
  EXPECT_EQ(Magnitude(-3.0).bound(), 0);
}

TEST(MpfrInterval, TellsItsRelativeWidth) {
  using CGAL::Bounding_arcs::Mpfr_interval;
  constexpr int BITS = 60;
  EXPECT_EQ(Mpfr_interval(3).relative_width(), 0);
  const Mpfr_interval third(Exact(1) / Exact(3), BITS);
  for (const Mpfr_interval& x : {third, -third}) {
    EXPECT_GT(x.relative_width(), 0);
    EXPECT_LE(x.relative_width(), std::exp2(1 - BITS));
  }
  EXPECT_EQ((third - third).relative_width(), HUGE_VAL);  // it holds 0
  EXPECT_EQ((Mpfr_interval(1) / (third - third)).relative_width(), HUGE_VAL);
}

TEST(MpfrInterval, ComparesOnlyWhatIsApart) {
  using CGAL::Bounding_arcs::Mpfr_interval;
  const auto between = [](double low, double high) { return joined(Mpfr_interval(low), Mpfr_interval(high)); };
  for (const auto& [a, b, is_less, is_known] : {std::tuple(between(1, 2), between(3, 4), true, true),
                                                {between(3, 4), between(1, 2), false, true},
                                                {between(2, 3), between(1, 2), false, true},
                                                {between(1, 2), between(2, 3), false, false},
                                                {between(2, 4), between(1, 3), false, false},
                                                {between(1, 4), between(2, 3), false, false}}) {
    const CGAL::Uncertain<bool> found = a < b;
    EXPECT_EQ(found.is_certain(), is_known) << a.lower() << ' ' << b.lower();
    if (is_known) {
      EXPECT_EQ(found.make_certain(), is_less) << a.lower() << ' ' << b.lower();
    }
  }
}

}  // namespace
}  // namespace test_bounded_arithmetic
