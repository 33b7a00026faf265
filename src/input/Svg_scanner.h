// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads an SVG attribute from left to right.
// Invariant: what was read is well-formed; every failure carries the character at which it lies.

#ifndef BOUNDING_ARCS_TOOL_SVG_SCANNER_H
#define BOUNDING_ARCS_TOOL_SVG_SCANNER_H

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace bounding_arcs_tool {

/// What is wrong with the value of an attribute.
struct Svg_error : std::runtime_error {
  Svg_error(std::size_t character_, const std::string& reason) : std::runtime_error(reason), character(character_) {}
  std::size_t character;  ///< counted in bytes from 1; 0 for the value as a whole
  std::string attribute;  ///< set where the attribute is known
};

/// A place in the value of an attribute. The text must outlive the scanner.
class Svg_scanner {
 public:
  explicit Svg_scanner(std::string_view text) : text_(text) {}

  [[nodiscard]] bool at_end() const { return at_ == text_.size(); }
  /// The next character, 0 at the end.
  [[nodiscard]] char next() const { return at_end() ? '\0' : text_[at_]; }
  /// The character about to be read, from 1.
  [[nodiscard]] std::size_t character() const { return at_ + 1; }
  /// Whether a number could start here.
  [[nodiscard]] bool at_number() const;

  void skip_space();
  /// White space with at most one comma in it.
  /// \return whether there was a comma
  bool skip_separator();
  /// Passes over `c` if it is next.
  bool accept(char c);
  /// A run of letters, and of % signs; may be empty.
  std::string word();

  /// The nearest double of an SVG number: sign, digits with a point anywhere, exponent.
  /// \throws Svg_error when there is none or its magnitude exceeds MAXIMUM_COORDINATE
  double number();
  /// An arc flag: the one character 0 or 1.
  /// \throws Svg_error
  bool flag();

  /// \throws Svg_error "expected WHAT, found ..."
  [[noreturn]] void expected(const std::string& what) const;
  /// \throws Svg_error
  [[noreturn]] void fail(const std::string& reason) const { throw Svg_error(character(), reason); }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace bounding_arcs_tool

#endif
