// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "answer_line.h"

#include "../../input/Curve_readers.h"
#include "../../input/Input_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <new>
#include <ostream>
#include <streambuf>
#include <string_view>

namespace bounding_arcs_tool {
namespace {

using nlohmann::json;

constexpr std::size_t LONGEST_ID = 1000, LONGEST_ERROR = 700;  // bytes
constexpr std::string_view WRONG_ID = "expected a string of at most 1000 bytes or a whole number, found another value";
const char* const NAMELESS = "curve";

// Takes the events of the parser until a key "id" of the record itself has its value, and stops there.
class Id_finder {
 public:
  bool null() { return scalar(json()); }
  bool boolean(bool x) { return scalar(json(x)); }
  bool number_integer(json::number_integer_t x) { return scalar(json(x)); }
  bool number_unsigned(json::number_unsigned_t x) { return scalar(json(x)); }
  bool number_float(json::number_float_t x, const std::string&) { return scalar(json(x)); }
  bool string(std::string& x) { return scalar(json(x)); }
  static bool binary(json::binary_t&) { return false; }  // not in JSON
  bool start_object(std::size_t) { return open(); }
  bool end_object() { return close(); }
  bool start_array(std::size_t) { return open(); }
  bool end_array() { return close(); }
  bool key(const std::string& key) {
    is_next_ = depth_ == 1 && key == "id";
    return true;
  }
  static bool parse_error(std::size_t, const std::string&, const json::exception&) { return false; }

  /// As JSON, "" if there is none.
  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] bool is_wrong() const { return is_wrong_; }

 private:
  bool scalar(const json& value) {
    if (!is_next_) return depth_ > 0;
    is_wrong_ =
        !(value.is_number_integer() || (value.is_string() && value.get_ref<const std::string&>().size() <= LONGEST_ID));
    if (!is_wrong_) id_ = value.dump();
    return false;
  }
  bool open() {
    is_wrong_ = is_next_;
    ++depth_;
    return !is_next_;
  }
  bool close() { return --depth_ > 0; }

  std::size_t depth_ = 0;
  bool is_next_ = false, is_wrong_ = false;
  std::string id_;
};

// One pass more for lines with an "id", which ends where that is: in front, as a rule.
Id_finder find_id(const std::string& line) {
  Id_finder finder;
  if (line.find("\"id\"") != line.npos) (void)json::sax_parse(line, &finder);
  return finder;
}

// Appends all that is written to a text, but for ends of lines: a JSON document has these between its values only.
class One_line_buffer : public std::streambuf {
 public:
  explicit One_line_buffer(std::string& text) : text_(text) {}

 protected:
  int_type overflow(int_type c) override {
    if (!traits_type::eq_int_type(c, traits_type::eof()) && c != '\n') text_ += traits_type::to_char_type(c);
    return traits_type::not_eof(c);
  }
  std::streamsize xsputn(const char* bytes, std::streamsize size) override {
    for (std::string_view rest(bytes, static_cast<std::size_t>(size)); !rest.empty();) {
      const std::size_t end = std::min(rest.find('\n'), rest.size());
      text_ += rest.substr(0, end);
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return size;
  }

 private:
  std::string& text_;
};

// Without what a line of a message begins with where there are files and lines in them.
std::string_view bare(std::string_view message) {
  for (const std::string_view head : {"record: ", "line 1, "})
    if (message.substr(0, head.size()) == head) message.remove_prefix(head.size());
  return message;
}

void add_error(std::string& out, const Line& line, const std::string& id, std::string_view message) {
  out += '{';
  if (!id.empty()) out += "\"id\":" + id + ',';
  out += "\"line\":" + std::to_string(line.number) +
         ",\"error\":" + json(one_line(bare(message), LONGEST_ERROR)).dump() + "}\n";
}

}  // namespace

bool answer_line(const Line& line, const Record_answer& answer, std::string& out) {
  const std::size_t start = out.size();
  std::string id;
  const auto refuse = [&](std::string_view message) {
    out.resize(start);
    add_error(out, line, id, message);
    return false;
  };
  try {
    if (line.is_too_long)
      return refuse("expected at most " + std::to_string(LONGEST_LINE) + " bytes, found a longer line");
    const Id_finder finder = find_id(line.text);
    id = finder.id();
    if (finder.is_wrong()) return refuse("id: " + std::string(WRONG_ID));
    One_line_buffer buffer(out);
    std::ostream document(&buffer);
    answer(read_json_curves(line.text, RECORD_NAME, NAMELESS).curves, document);
    if (!id.empty()) out.insert(start + 1, "\"id\":" + id + ',');
    out += '\n';
    return true;
  } catch (const std::bad_alloc&) {
    return refuse("out of memory");
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

}  // namespace bounding_arcs_tool
