// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lexical grammar of SVG attributes.

#include "Svg_scanner.h"

#include "Input_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace bounding_arcs_tool {

namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
bool is_letter(char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z'); }

// Greater than any exponent that the digits of a file can make up for.
constexpr long long FAR_EXPONENT = 1LL << 40;

// Whether a decimal number that is not zero and no double comes near is too small, not too great: whether its first
// digit other than 0 comes after the point once the exponent has moved that.
bool is_tiny(std::string_view digits) {
  const std::size_t end = std::min(digits.find_first_of("eE"), digits.size());
  const std::size_t point = std::min(digits.find('.'), end);
  const std::size_t leading = std::min(digits.find_first_of("123456789"), end);
  long long exponent = 0;
  if (end < digits.size()) {
    const std::size_t sign = digits[end + 1] == '+' ? 1 : 0;
    const char* const first = digits.data() + end + 1 + sign;
    const auto status = std::from_chars(first, digits.data() + digits.size(), exponent).ec;
    if (status != std::errc()) exponent = *first == '-' ? -FAR_EXPONENT : FAR_EXPONENT;
  }
  return static_cast<long long>(point) - static_cast<long long>(leading) + exponent < 0;
}

}  // namespace

bool Svg_scanner::at_number() const {
  std::string_view rest = text_.substr(at_);
  if (!rest.empty() && (rest[0] == '+' || rest[0] == '-')) rest.remove_prefix(1);
  if (!rest.empty() && rest[0] == '.') rest.remove_prefix(1);
  return !rest.empty() && is_digit(rest[0]);
}

void Svg_scanner::skip_space() {
  while (!at_end() && is_space(text_[at_])) ++at_;
}

bool Svg_scanner::skip_separator() {
  skip_space();
  const bool comma = accept(',');
  if (comma) skip_space();
  return comma;
}

bool Svg_scanner::accept(char c) {
  if (at_end() || text_[at_] != c) return false;
  ++at_;
  return true;
}

std::string Svg_scanner::word() {
  const std::size_t start = at_;
  while (!at_end() && (is_letter(text_[at_]) || text_[at_] == '%')) ++at_;
  return std::string(text_.substr(start, at_ - start));
}

double Svg_scanner::number() {
  if (!at_number()) expected("a number");
  const char* const start = text_.data() + at_ + (text_[at_] == '+' ? 1 : 0);
  double value = 0;
  const auto [end, status] = std::from_chars(start, text_.data() + text_.size(), value);
  const std::string_view digits(start, static_cast<std::size_t>(end - start));
  const bool too_great = status == std::errc::result_out_of_range && !is_tiny(digits);
  if (too_great || std::abs(value) > MAXIMUM_COORDINATE)
    fail("expected a number of magnitude at most 2^1000, found " + in_quotes(digits));
  at_ = static_cast<std::size_t>(end - text_.data());
  return status == std::errc() ? value : 0;
}

bool Svg_scanner::flag() {
  if (next() != '0' && next() != '1') expected("an arc flag 0 or 1");
  return text_[at_++] == '1';
}

void Svg_scanner::expected(const std::string& what) const {
  const std::string_view rest = text_.substr(at_);
  // At least one character, so that an unexpected comma shows too.
  const std::string_view found = rest.substr(0, rest.find_first_of(" \t\n\r,", 1));
  fail("expected " + what + ", found " + (at_end() ? "the end" : in_quotes(found)));
}

}  // namespace bounding_arcs_tool
