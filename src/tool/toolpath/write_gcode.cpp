// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_gcode.h"

#include "../number_text.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace bounding_arcs_tool {
namespace {

constexpr int FEED_DIGITS = 6;

// A number of so many units of the digit, without zeros at its end. Controllers know no exponents.
std::string decimal(std::int64_t count, int digits) {
  std::string text = std::to_string(std::llabs(count));
  const auto behind = static_cast<std::size_t>(digits);
  if (text.size() <= behind) text.insert(0, behind + 1 - text.size(), '0');
  text.insert(text.size() - behind, 1, '.');
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return count < 0 ? "-" + text : text;
}
// That number again. Nothing where it is no number or has more digits.
std::optional<std::int64_t> count_of(const std::string& text, int digits) {
  const std::size_t start = !text.empty() && text.front() == '-' ? 1 : 0;
  const std::size_t point = (std::min)(text.find('.'), text.size());
  std::string all = text.substr(start, point - start);
  if (point < text.size()) all += text.substr(point + 1);
  const std::size_t behind = point < text.size() ? text.size() - point - 1 : 0, most = static_cast<std::size_t>(digits);
  constexpr std::size_t LONGEST = 18;
  if (all.empty() || all.find_first_not_of("0123456789") != std::string::npos || behind > most) return std::nullopt;
  all.append(most - behind, '0');
  if (all.size() > LONGEST) return std::nullopt;
  const std::int64_t count = std::strtoll(all.c_str(), nullptr, 10);
  return start == 1 ? -count : count;
}

std::string comment(const std::string& text) {
  constexpr std::size_t LONGEST = 60;  // some controllers have lines of 80 characters
  std::string safe;
  for (const char c : text.substr(0, LONGEST)) safe += c >= ' ' && c < 0x7f && c != '(' && c != ')' ? c : '_';
  return "(" + safe + ")\n";
}

// How far the tool goes at its feed, and through the air above it.
struct Way {
  double cut = 0, air = 0;
};
Way way_of(const Gcode_program& program) {
  Way way;
  Gcode_place place{};
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const Gcode_move& m = program.moves[i];
    const double chord = std::hypot(static_cast<double>(m.to.x - place.x), static_cast<double>(m.to.y - place.y));
    double length = chord;
    if (m.motion > 1) {
      const double radius = std::hypot(static_cast<double>(m.i), static_cast<double>(m.j));
      length = 2 * radius * std::asin((std::min)(chord / 2 / radius, 1.0));
    }
    (m.motion == 0 ? way.air : way.cut) += length;
    place = m.to;
  }
  return way;
}

[[noreturn]] void differ(const std::string& expected, const std::string& found) {
  throw std::invalid_argument("G-code that was read back: expected " + expected + ", found " + found);
}

// The words of a line: a letter and a number each.
struct Word {
  char letter;
  std::string number;
};
std::vector<Word> words_of(const std::string& line) {
  std::vector<Word> words;
  std::istringstream in(line.substr(0, line.find('(')));
  for (std::string word; in >> word;) words.push_back({word.front(), word.substr(1)});
  return words;
}

}  // namespace

std::string gcode_text(const Gcode_program& program, const std::vector<Tool_pass>& passes, const Gcode_setup& setup) {
  const auto count = [&](std::int64_t n) { return decimal(n, setup.digits); };
  const double unit = std::pow(10, setup.digits);
  const Way way = way_of(program);
  std::string text = setup.is_in_inches ? "(units: inches)\n" : "(units: mm)\n";
  text += comment("passes: " + std::to_string(passes.size()) + ", cut " + short_number(way.cut / unit) + ", air " +
                  short_number(way.air / unit) + " beside lifts");
  if (program.broken > 0) text += comment("arcs: " + std::to_string(program.broken) + " became lines");
  text += setup.is_in_inches ? "G17 G20 G90 G91.1 G94\n" : "G17 G21 G90 G91.1 G94\n";
  const std::string feed = decimal(std::llround(setup.feed * setup.scale * std::pow(10, FEED_DIGITS)), FEED_DIGITS);
  std::size_t pass = Gcode_source::NONE;
  Gcode_place place = program.moves.front().to;
  bool is_placed = false, has_feed = false;
  for (std::size_t i = 0; i < program.moves.size(); ++i) {
    const Gcode_move& move = program.moves[i];
    const Gcode_source& source = program.sources[i];
    const bool is_along = move.to.x != place.x || move.to.y != place.y || move.motion > 1 || (i > 0 && !is_placed);
    if (is_along && source.pass != pass) text += comment(passes[pass = source.pass].title);
    text += 'G' + std::to_string(move.motion);
    if (is_along) text += " X" + count(move.to.x) + " Y" + count(move.to.y);
    if (move.to.z != place.z || i == 0) text += " Z" + count(move.to.z);
    if (move.motion > 1) text += " I" + count(move.i) + " J" + count(move.j);
    if (move.motion == 1 && !has_feed) text += " F" + feed;
    text += '\n';
    has_feed = move.motion > 0;
    is_placed = is_placed || is_along;
    place = move.to;
  }
  return text + "M2\n";
}

std::vector<Gcode_move> read_gcode(const std::string& text, const Gcode_setup& setup) {
  std::vector<Gcode_move> moves;
  Gcode_place place;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    Gcode_move move{-1, place};
    for (const Word& word : words_of(line)) {
      if (word.letter == 'F' || word.letter == 'M') continue;
      if (word.letter == 'G') {
        if (word.number.size() == 1 && word.number < "4") move.motion = word.number.front() - '0';
        continue;
      }
      const std::optional<std::int64_t> count = count_of(word.number, setup.digits);
      std::int64_t* const target = word.letter == 'X'   ? &move.to.x
                                   : word.letter == 'Y' ? &move.to.y
                                   : word.letter == 'Z' ? &move.to.z
                                   : word.letter == 'I' ? &move.i
                                   : word.letter == 'J' ? &move.j
                                                        : nullptr;
      if (!count || target == nullptr) differ("words of moves", "\"" + line + "\"");
      *target = *count;
    }
    if (move.motion < 0) continue;  // units, or the end
    moves.push_back(move);
    place = move.to;
  }
  return moves;
}

namespace {

// Follows passes along moves.
class Gcode_checker {
 public:
  Gcode_checker(const std::vector<Tool_pass>& passes, const Gcode_setup& setup) : passes_(passes), setup_(setup) {}

  void add(const Gcode_move& move, const Gcode_source& source) {
    if (source.is_cut()) add_cut(move, source);
    else add_way(move, source);
    place_ = move.to;
  }
  // What comes next is of that piece of that pass, or behind all; pieces before it are where the tool is.
  void skip_to(std::size_t pass, std::size_t piece) {
    for (; pass_ < passes_.size() && (pass_ != pass || piece_ != piece); ++piece_) {
      if (piece_ == passes_[pass_].pieces.size()) {
        if (pass_ == pass)
          differ("pieces one after the other", "piece " + std::to_string(piece) + " behind later ones");
        ++pass_, piece_ = static_cast<std::size_t>(-1);
        continue;
      }
      const Xy<double> end = in_counts(setup_, passes_[pass_].pieces[piece_]).to;
      expect_near(apart(end), "the end of each piece");
      expect_height(place_.z, passes_[pass_].height_at(piece_ + 1));
    }
  }

 private:
  [[nodiscard]] double apart(const Xy<double>& p) const {
    return std::hypot(p.x - static_cast<double>(place_.x), p.y - static_cast<double>(place_.y));
  }
  void expect_near(double error, const std::string& what) const {
    const double unit = setup_.counts(1);
    if (!(error <= MOVE_ERROR))
      differ(what + " within " + short_number(MOVE_ERROR / unit) + " of its place", short_number(error / unit));
  }
  void expect_height(std::int64_t z, double height) const {
    if (!(std::fabs(static_cast<double>(z) - setup_.counts(height)) <= 1))
      differ("a height of " + short_number(height), short_number(static_cast<double>(z) / setup_.counts(1)));
  }
  void add_way(const Gcode_move& move, const Gcode_source& source) {
    if (is_begun_) skip_to(source.pass == Gcode_source::NONE ? passes_.size() : source.pass, 0);
    is_begun_ = true;
    const bool is_along = move.to.x != place_.x || move.to.y != place_.y;
    if (move.motion == 0) {
      expect_height(move.to.z, setup_.safe_height);
      if (is_along) expect_height(place_.z, setup_.safe_height);
      return;
    }
    if (is_along || move.motion != 1) differ("ways to a pass through the air", "one along the work");
    expect_near(apart(in_counts(setup_, passes_[source.pass].pieces.front()).from), "the start of each pass");
    expect_height(move.to.z, passes_[source.pass].height_at(0));
  }
  void add_cut(const Gcode_move& move, const Gcode_source& source) {
    skip_to(source.pass, source.piece);
    const Tool_pass& pass = passes_[source.pass];
    const Arc_2 whole = in_counts(setup_, pass.pieces[source.piece]);
    if (source.from == 0) expect_near(apart(whole.from), "the start of each piece");
    const double h0 = pass.height_at(source.piece), h1 = pass.height_at(source.piece + 1);
    expect_height(move.to.z, pass.heights.empty() ? h1 : h0 + source.to * (h1 - h0));
    expect_near(deviation(setup_, place_, move, part_of(whole, source)), "each move");
    if (source.to == 1) ++piece_;
  }
  // The part of an arc between two shares of its length.
  static Arc_2 part_of(const Arc_2& arc, const Gcode_source& source) {
    if (source.from == 0 && source.to == 1) return arc;
    const auto end = [&](double share) {
      return share == 0 ? arc.from : (share == 1 ? arc.to : CGAL::Bounding_arcs::point(arc, share));
    };
    return {end(source.from), end(source.to), std::tan(std::atan(arc.bulge) * (source.to - source.from))};
  }

  const std::vector<Tool_pass>& passes_;
  const Gcode_setup& setup_;
  Gcode_place place_;
  std::size_t pass_ = 0, piece_ = 0;  // what comes next
  bool is_begun_ = false;
};

}  // namespace

void check_gcode(const std::vector<Gcode_move>& moves, const Gcode_program& program,
                 const std::vector<Tool_pass>& passes, const Gcode_setup& setup) {
  if (moves.size() != program.sources.size())
    differ(std::to_string(program.sources.size()) + " moves", std::to_string(moves.size()));
  Gcode_checker checker(passes, setup);
  for (std::size_t i = 0; i < moves.size(); ++i) checker.add(moves[i], program.sources[i]);
  checker.skip_to(passes.size(), 0);
}

void write_gcode(std::ostream& out, const std::vector<Tool_pass>& passes, const Gcode_setup& setup) {
  const Gcode_program program = gcode_program(passes, setup);
  const std::string text = gcode_text(program, passes, setup);
  check_gcode(read_gcode(text, setup), program, passes, setup);
  out << setup.header;
  if (!setup.header.empty() && setup.header.back() != '\n') out << '\n';
  out << text;
}

}  // namespace bounding_arcs_tool
