// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Dxf_text.h"

#include "Input_text.h"

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace bounding_arcs_tool {
namespace {

constexpr std::string_view ESCAPE = "\\U+";
constexpr std::size_t DIGITS = 4, LENGTH = ESCAPE.size() + DIGITS;
constexpr unsigned HIGH_SURROGATE = 0xD800, LOW_SURROGATE = 0xDC00, BEHIND_SURROGATES = 0xE000,
                   BEYOND_16_BITS = 0x10000;

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

void append_utf8(std::string& text, unsigned code) {
  const auto add = [&](unsigned lead, int more) {
    text += static_cast<char>(lead | code >> (6 * more));
    while (more-- > 0) text += static_cast<char>(0x80 | (code >> (6 * more) & 0x3F));
  };
  if (code < 0x80) add(0, 0);
  else if (code < 0x800) add(0xC0, 1);
  else if (code < BEYOND_16_BITS) add(0xE0, 2);
  else add(0xF0, 3);
}

// The characters of the code page 1252 from 0x80 on that are not those of Unicode; the five that it lacks are.
unsigned code_of_1252(unsigned char byte) {
  constexpr unsigned CODES[] = {0x20AC, 0x81,   0x201A, 0x192,  0x201E, 0x2026, 0x2020, 0x2021, 0x2C6,  0x2030, 0x160,
                                0x2039, 0x152,  0x8D,   0x17D,  0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
                                0x2013, 0x2014, 0x2DC,  0x2122, 0x161,  0x203A, 0x153,  0x9D,   0x17E,  0x178};
  return byte >= 0x80 && byte < 0xA0 ? CODES[byte - 0x80] : byte;
}

bool is_of_1252(std::string_view text) {
  constexpr std::string_view NAME = "$DWGCODEPAGE", PAGE = "ANSI_1252";
  const std::size_t at = text.find(NAME);
  if (at == text.npos) return false;
  constexpr std::size_t LONGEST = 40;  // of a code, line ends and the page
  std::string page(text.substr(at + NAME.size(), LONGEST));
  std::transform(page.begin(), page.end(), page.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return page.find(PAGE) != page.npos;
}

// The number of an escape at the beginning of a text, 0 for none.
unsigned escaped(std::string_view text) {
  unsigned code = 0;
  if (text.size() < LENGTH || text.substr(0, ESCAPE.size()) != ESCAPE) return 0;
  const char* const last = text.data() + LENGTH;
  return std::from_chars(last - DIGITS, last, code, 16).ptr == last ? code : 0;
}

// A character and how many bytes tell it; what is none, or a control character, is left as it stands.
struct Escaped {
  unsigned code = 0;
  std::size_t length = 0;
};
Escaped escaped_character(std::string_view text) {
  constexpr unsigned FIRST = 0x20, DELETE = 0x7F, LAST_CONTROL = 0x9F;
  const unsigned code = escaped(text);
  if (code < FIRST || (code >= DELETE && code <= LAST_CONTROL)) return {};
  if (code < HIGH_SURROGATE || code >= BEHIND_SURROGATES) return {code, LENGTH};
  const unsigned low = code < LOW_SURROGATE ? escaped(text.substr(LENGTH)) : 0;
  if (low < LOW_SURROGATE || low >= BEHIND_SURROGATES) return {};
  return {BEYOND_16_BITS + ((code - HIGH_SURROGATE) << 10) + (low - LOW_SURROGATE), 2 * LENGTH};
}

}  // namespace

std::optional<std::string> dxf_as_utf8(std::string_view text) {
  const bool is_converted =
      !std::all_of(text.begin(), text.end(), is_ascii) && valid_utf8(text) != text && is_of_1252(text);
  if (!is_converted && text.find(ESCAPE) == text.npos) return std::nullopt;
  std::string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) {
    const Escaped found = text[i] == ESCAPE.front() ? escaped_character(text.substr(i)) : Escaped{};
    if (found.length > 0) append_utf8(result, found.code);
    else if (is_converted) append_utf8(result, code_of_1252(static_cast<unsigned char>(text[i])));
    else result += text[i];
    i += std::max<std::size_t>(found.length, 1);
  }
  return result;
}

std::string dxf_as_ascii(std::string_view text) {
  std::string result;
  const std::string utf8 = valid_utf8(text);
  const auto escape = [&](unsigned code) {
    constexpr char HEXADECIMAL[] = "0123456789ABCDEF";
    result += ESCAPE;
    for (int shift = 12; shift >= 0; shift -= 4) result += HEXADECIMAL[code >> shift & 15];
  };
  for (std::size_t i = 0; i < utf8.size();) {
    if (is_ascii(utf8[i])) {
      result += utf8[i++];
      continue;
    }
    const auto lead = static_cast<unsigned char>(utf8[i]);
    const std::size_t length = lead >= 0xF0 ? 4 : (lead >= 0xE0 ? 3 : 2);
    unsigned code = lead & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) code = code << 6 | (static_cast<unsigned char>(utf8[i + k]) & 0x3Fu);
    if (code >= BEYOND_16_BITS) {
      escape(HIGH_SURROGATE + ((code - BEYOND_16_BITS) >> 10));
      escape(LOW_SURROGATE + ((code - BEYOND_16_BITS) & 0x3FF));
    } else {
      escape(code);
    }
    i += length;
  }
  return result;
}

}  // namespace bounding_arcs_tool
