// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Memory while JSON curve files are read, counted in what operator new gives out: at most 12 bytes a byte of text,
// whatever the text is made of. That is the records in vectors that double, and nothing beside them: a document as a
// tree takes several times as much.

#include "../support/cases.h"
#include "../support/curve_text.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t HEADER = alignof(std::max_align_t);  // holds the size, and keeps what follows aligned
std::size_t held = 0, most_held = 0;

}  // namespace

void* operator new(std::size_t size) {
  char* const block = static_cast<char*>(std::malloc(size + HEADER));
  if (block == nullptr) throw std::bad_alloc();
  std::memcpy(block, &size, sizeof size);
  held += size;
  most_held = std::max(most_held, held);
  return block + HEADER;
}

void operator delete(void* pointer) noexcept {
  if (pointer == nullptr) return;
  char* const block = static_cast<char*>(pointer) - HEADER;
  std::size_t size = 0;
  std::memcpy(&size, block, sizeof size);
  held -= size;
  std::free(block);
}

void operator delete(void* pointer, std::size_t) noexcept { operator delete(pointer); }

namespace {

using namespace bounding_arcs_test;

constexpr std::size_t MOST_PER_BYTE = 12, TEXT_ITSELF = 1;
constexpr int MANY = FEW_CASES ? 30000 : 100000;

const std::string LINE = R"({"type":"bezier","degree":1,"control_points":[[0,0],[1,1]]})";
const std::string SPLINE = R"({"type":"bspline","degree":1)";

std::string list_of(const std::string& item, int times) { return "[" + repeated(item + ",", times - 1) + item + "]"; }

// The records of a text, or none if there is something wrong with it, within the bound.
Records expect_bounded_read(const std::string& text) {
  const std::size_t before = held;
  most_held = held;
  Records records;
  const std::string message = message_of([&] { records = read(text); });
  EXPECT_LE(most_held - before, (MOST_PER_BYTE - TEXT_ITSELF) * text.size()) << message << ": " << text.substr(0, 200);
  return records;
}

TEST(ReadMemory, IsBoundedForManyCurves) {
  EXPECT_EQ(expect_bounded_read("{\"curves\":" + list_of(LINE, 2 * MANY) + "}").size(), 2u * MANY);
}

TEST(ReadMemory, IsBoundedForLongLists) {
  const std::string points = ",\"control_points\":" + list_of("[0,0]", MANY), ones = list_of("1", MANY);
  const auto records = expect_bounded_read(SPLINE + points + ",\"knots\":\"uniform\",\"weights\":" + ones + "}");
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].control_points.size(), static_cast<std::size_t>(MANY));
  expect_bounded_read(SPLINE + points + ",\"knots\":" + ones + "}");
  expect_bounded_read(SPLINE + points + ",\"periodic\":true,\"knots\":" + ones + "}");
  expect_bounded_read(SPLINE + points + ",\"knots\":\"uniform\",\"periodic\":true}");
}

TEST(ReadMemory, IsBoundedForListsOfWhatShouldNotBeThere) {
  for (const std::string item : {"{}", "[]", "[1]", "0", "null", "\"\"", "[[[[]]]]", "{\"\":{}}"})
    for (const std::string key : {"control_points", "weights", "knots", "name", "comment"}) {
      SCOPED_TRACE(key + ' ' + item);
      expect_bounded_read(SPLINE + ",\"" + key + "\":" + list_of(item, MANY) + "}");
    }
}

TEST(ReadMemory, IsBoundedForManyKeysAndLongNames) {
  std::string keys = "{\"k\":0";
  for (int i = 0; i < MANY; ++i) keys += ",\"" + std::to_string(i) + "\":0";
  expect_bounded_read(keys + "}");
  const std::string named = R"({"name":")" + repeated("long ", MANY) + "\"," + LINE.substr(1);
  EXPECT_EQ(expect_bounded_read(named).size(), 1u);
  expect_bounded_read("{\"" + repeated("long ", MANY) + "\":[[[[{}]]]]}");
}

}  // namespace
