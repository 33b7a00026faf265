// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "colour_numbers.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

namespace bounding_arcs_tool {
namespace {

constexpr int BLACK_OR_WHITE = 7, FIRST_HUE = 10, FIRST_GREY = 250, LAST = 255;

int packed(int red, int green, int blue) { return (red << 16) | (green << 8) | blue; }

// From 10 on there are 24 hues, 15 degrees apart, each at five values, full and half saturated.
int hue(int number) {
  constexpr int VALUES[] = {255, 165, 127, 76, 38}, SECTOR = 4;
  const int value = VALUES[number % 10 / 2], least = number % 2 == 0 ? 0 : value / 2;
  const int at = (number - FIRST_HUE) / 10, part = at % SECTOR;
  const int rising = least + (value - least) * part / SECTOR,
            falling = least + (value - least) * (SECTOR - part) / SECTOR;
  switch (at / SECTOR) {
    case 0:
      return packed(value, rising, least);
    case 1:
      return packed(falling, value, least);
    case 2:
      return packed(least, value, rising);
    case 3:
      return packed(least, falling, value);
    case 4:
      return packed(rising, least, value);
    default:
      return packed(value, least, falling);
  }
}

int distance(int a, int b) {
  int sum = 0;
  for (const int shift : {0, 8, 16}) {
    const int d = ((a >> shift) & 255) - ((b >> shift) & 255);
    sum += d * d;
  }
  return sum;
}

}  // namespace

int rgb_of_colour_number(int number) {
  constexpr int FIRST[] = {0, 0xFF0000, 0xFFFF00, 0x00FF00, 0x00FFFF, 0x0000FF, 0xFF00FF, 0, 0x808080, 0xC0C0C0};
  constexpr int GREYS[] = {0x333333, 0x505050, 0x696969, 0x828282, 0xBEBEBE, 0xFFFFFF};
  if (number < FIRST_HUE) return FIRST[number];
  return number < FIRST_GREY ? hue(number) : GREYS[number - FIRST_GREY];
}

int colour_number_of_rgb(int rgb) {
  if (rgb == 0 || rgb == 0xFFFFFF) return BLACK_OR_WHITE;
  int best = BLACK_OR_WHITE, least = std::numeric_limits<int>::max();
  for (int number = 1; number <= LAST; ++number) {
    const int d = distance(rgb, rgb_of_colour_number(number));
    if (d < least && number != BLACK_OR_WHITE) best = number, least = d;
  }
  return best;
}

}  // namespace bounding_arcs_tool
