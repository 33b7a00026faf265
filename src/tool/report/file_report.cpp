// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "File_report.h"
#include "../Comparison.h"
#include "Nested_trees.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace bounding_arcs_tool {
namespace {

// The share of the room, one in so many, that may be taken by the rows of single curves, and by what was asked beside
// the regions.
constexpr std::size_t SHARES = 4;

Box box_of(const std::vector<Loaded_curve>& curves) {
  Box box;
  for (const Loaded_curve& curve : curves)
    for (const auto& bezier : curve.record.bezier_pieces<double>()) box.add(bezier);
  return box;
}

template <class Items, class Json_of> std::string list(const Items& items, const Json_of& json_of) {
  std::string out = "[";
  for (const auto& item : items) out += (out.size() > 1 ? "," : "") + json_of(item);
  return out + "]";
}

// 1e-1, ..., 1e-6 of the extent in two digits, so that the command line says the same numbers.
std::vector<double> tolerances_of(const Box& box) {
  const double extent = std::max(box.x1 - box.x0, box.y1 - box.y0);
  std::vector<double> eps;
  for (int power = 1; power <= 6; ++power) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1e", (extent > 0 ? extent : 1) * std::pow(10.0, -power));
    const double e = std::strtod(text, nullptr);
    if (e > std::numeric_limits<double>::min()) eps.push_back(e);
  }
  return eps;
}

bool can_reach(const std::vector<Loaded_curve>& curves, const Options& options, double eps) {
  for (const Loaded_curve& curve : curves)
    for (const Method method : options.methods)
      if (curve.segmented->build(method, Split::MIDPOINT, eps, options.max_regions, {})->status() != Status::COMPLETE)
        return false;
  return true;
}

std::string piece_json(const Page_scale& scale, const Bezier_curve_2<double>& bezier) {
  const std::string points = list(bezier.control_points(), [&](const Xy<double>& p) { return scale.point(p); });
  if (!bezier.is_rational()) return points;
  return "{\"p\":" + points + ",\"w\":" + list(bezier.weights(), number) + "}";
}

// The drawing of some curves and tolerances, or nothing where it takes more than the room.
struct Drawing {
  std::string curves;
  std::vector<std::vector<Halvings>> halvings;  // of each method, of each level
};
std::optional<Drawing> drawing_of(const std::vector<Loaded_curve>& curves, std::size_t count,
                                  const std::vector<double>& eps, const Page_scale& scale, const Options& options,
                                  std::size_t room) {
  Drawing drawing{"[", std::vector<std::vector<Halvings>>(options.methods.size())};
  for (std::size_t i = 0; i < count; ++i) {
    const Loaded_curve& curve = curves[i];
    std::string ends, nodes;
    for (std::size_t m = 0; m < options.methods.size() && !eps.empty(); ++m) {
      const Nested_trees trees(curve, options.methods[m], eps, options);
      if (m == 0) ends = trees.ends_json(scale);
      nodes += (m > 0 ? "," : "") + trees.nodes_json(scale);
      trees.add_halvings(drawing.halvings[m]);
    }
    drawing.curves += (i > 0 ? ",\n{" : "{") + ("\"name\":" + page_string(curve.record.name)) +
                      ",\"beziers\":" + std::to_string(curve.segmented->number_of_beziers()) +
                      ",\"spirals\":" + std::to_string(curve.segmented->number_of_spirals()) + ",\"pieces\":" +
                      list(curve.record.bezier_pieces<double>(),
                           [&](const Bezier_curve_2<double>& bezier) { return piece_json(scale, bezier); }) +
                      ",\"ends\":" + (ends.empty() ? "[]" : ends) + ",\"nodes\":[" + nodes + "]}";
    if (drawing.curves.size() > room) return std::nullopt;
  }
  drawing.curves += "]";
  return drawing;
}

std::string row_json(const Comparison_row& row, const Options& options, const std::vector<double>& eps) {
  const auto index = [](const auto& items, const auto& item) {
    return std::to_string(std::find(items.begin(), items.end(), item) - items.begin());
  };
  return "[" + (row.place == Comparison_row::ALL ? "-1" : std::to_string(row.place)) + "," +
         index(options.methods, row.method) + "," + index(eps, row.eps) + "," + short_number(row.segmentation.least) +
         "," + short_number(row.build.least) + "," + short_number(row.regions.least - row.build.least) + "," +
         std::to_string(row.size.regions) + "," + std::to_string(row.size.arcs) + "," + std::to_string(row.size.nodes) +
         "," + short_number(row.thickness) + "]";
}

// Writes of each level how many pieces were halved, the geometric means of their size and thickness, and how these
// change.
std::string halvings_json(const std::vector<Halvings>& levels) {
  return list(levels, [](const Halvings& h) {
    if (h.count == 0) return std::string("[0,0,0,0,0]");
    const double n = static_cast<double>(h.count);
    return "[" + std::to_string(h.count) + "," + short_number(std::exp(h.size / n)) + "," +
           short_number(std::exp(h.thickness / n)) + "," + short_number(h.size_change / n) + "," +
           short_number(h.thickness_change / n) + "]";
  });
}

std::string overlay_json(const Overlay& overlay, const Page_scale& scale, std::size_t room,
                         std::vector<std::string>& notes) {
  std::string marks, chains, rows;
  std::size_t left_out = 0;
  // What is too long is left out, one by one.
  const auto add = [&](std::string& to, const std::string& text) {
    if (marks.size() + chains.size() + text.size() > room) ++left_out;
    else to += (to.empty() ? "" : ",") + text;
  };
  for (const Mark& mark : overlay.answer.marks)
    add(marks, "[" + std::to_string(static_cast<int>(mark.kind)) + "," +
                   list(mark.points, [&](const Xy<double>& p) { return scale.point(p); }) + "]");
  for (const std::vector<Arc_2>& chain : overlay.chains)
    add(chains, "[" + scale.point(chain.front().from) + "," +
                    list(chain, [&](const Arc_2& p) { return scale.bulge(p) + "," + scale.point(p.to); }).substr(1));
  if (left_out > 0)
    notes.push_back("Of \"" + overlay.answer.title + "\" " + std::to_string(left_out) + " of " +
                    std::to_string(overlay.answer.marks.size() + overlay.chains.size()) +
                    " lines and points are not drawn, as the page would be too large.");
  constexpr std::size_t MOST = 200;
  const auto& all = overlay.answer.rows;
  if (all.size() > MOST)
    notes.push_back("Of \"" + overlay.answer.title + "\" " + std::to_string(MOST) + " of " +
                    std::to_string(all.size()) + " rows are shown.");
  for (std::size_t i = 0; i < all.size() && i < MOST; ++i) rows += (i > 0 ? "," : "") + list(all[i], page_string);
  return "{\"title\":" + page_string(overlay.answer.title) +
         ",\"columns\":" + list(overlay.answer.columns, page_string) + ",\"rows\":[" + rows + "],\"marks\":[" + marks +
         "],\"chains\":[" + chains + "]}";
}

}  // namespace

std::string page_string(const std::string& text) {
  std::string out;
  for (const char c : nlohmann::json(text).dump(-1, ' ', true, nlohmann::json::error_handler_t::replace))
    if (c == '<') out += "\\u003c";
    else out += c;
  return out;
}

std::string page_text(const std::string& text) {
  return escaped(nlohmann::json::parse(page_string(text)).get<std::string>());
}

std::string file_json(const std::string& file, CGAL::Bounding_arcs::Curve_file&& read, const Report_words& words,
                      const Options& given, std::size_t room) {
  Options options = given;
  const std::vector<Loaded_curve> curves = cut_curves(file, std::move(read.curves), options.kernel);
  const Box box = box_of(curves);
  const bool flips =
      std::any_of(curves.begin(), curves.end(), [](const Loaded_curve& c) { return !c.record.y_is_down; });
  std::vector<std::string> notes;
  if (!read.notes.empty()) notes.push_back("In the file: " + ba::Curve_file::text_of(read.notes) + ".");
  if (options.eps.empty()) {
    options.eps = tolerances_of(box);
    const std::size_t asked = options.eps.size();
    while (!options.eps.empty() && !can_reach(curves, options, options.eps.back())) options.eps.pop_back();
    if (options.eps.size() < asked)
      notes.push_back("Tolerances below " +
                      (options.eps.empty() ? "the drawing's extent" : digits(options.eps.back())) +
                      " are left out: they are below what coordinates resolve, or take too many regions.");
  }
  const std::vector<double>& eps = options.eps;

  std::vector<Comparison_row> rows;
  {
    Progress_line progress("measuring " + file + ", rows");
    rows = comparison(curves, options, [&](std::size_t done, std::size_t all) { progress(done, all); });
  }
  const std::vector<Comparison_row> sums = totals(rows);
  const auto json_of_row = [&](const Comparison_row& row) { return row_json(row, options, eps); };
  const auto join = [](const std::string& a, const std::string& b) {
    return a + (a.empty() || b.empty() ? "" : ",") + b;
  };
  const auto items = [&](const std::vector<Comparison_row>& some) {
    const std::string text = list(some, json_of_row);
    return text.substr(1, text.size() - 2);
  };
  std::string table = items(rows);
  if (table.size() > room / SHARES) {
    table.clear();
    notes.push_back("The table has no rows of single curves, of which there are " + std::to_string(curves.size()) +
                    ".");
  }
  table = join(items(sums), table);

  std::size_t drawn = eps.size(), count = curves.size();
  const Page_scale scale(box, flips, eps.empty() ? (box.x1 > box.x0 ? box.x1 - box.x0 : 1) : eps.back());
  const std::vector<Overlay> overlays =
      overlays_of(file, curves, read.rule, words, eps.empty() ? 1 : eps[eps.size() / 2]);
  std::vector<std::string> overlay_texts;
  std::size_t used = table.size();
  for (const Overlay& overlay : overlays) {
    overlay_texts.push_back(overlay_json(overlay, scale, room / SHARES / overlays.size(), notes));
    used += overlay_texts.back().size();
  }
  const std::size_t left = room > used ? room - used : 0;
  std::optional<Drawing> drawing;
  while (!drawing) {
    // short of what most nodes take
    constexpr std::size_t BYTES = 24;
    std::size_t nodes = 0;
    for (const Comparison_row& sum : sums)
      if (drawn > 0 && sum.eps == eps[drawn - 1]) nodes += sum.size.nodes;
    if (nodes <= left / BYTES)
      drawing = drawing_of(curves, count, {eps.begin(), eps.begin() + static_cast<std::ptrdiff_t>(drawn)}, scale,
                           options, left);
    if (drawing) break;
    if (drawn > 0) --drawn;
    else count /= 2;
  }
  if (drawn < eps.size())
    notes.push_back("Regions for tolerances below " + (drawn > 0 ? digits(eps[drawn - 1]) : "those in the table") +
                    " are not drawn, as the page would be too large; the table has their numbers.");
  if (count < curves.size())
    notes.push_back("Of " + std::to_string(curves.size()) + " curves the first " + std::to_string(count) +
                    " are drawn, as the page would be too large.");

  std::string halvings = list(drawing->halvings, halvings_json);
  return "{\"name\":" + page_string(file) + ",\"eps\":" + list(eps, digits) + ",\"drawn\":" + std::to_string(drawn) +
         ",\"number\":" + std::to_string(curves.size()) + ",\"scale\":" + number(scale.scale()) + ",\"box\":[" +
         number((box.x1 - box.x0) * scale.scale()) + "," + number((box.y1 - box.y0) * scale.scale()) +
         "],\n\"rows\":[" + table + "],\n\"halvings\":" + halvings + ",\"notes\":" + list(notes, page_string) +
         ",\n\"overlays\":" + list(overlay_texts, [](const std::string& text) { return text; }) +
         ",\n\"curves\":" + drawing->curves + "}";
}

}  // namespace bounding_arcs_tool
