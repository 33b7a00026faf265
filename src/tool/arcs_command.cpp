// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs arcs: curves as few arcs and segments as a tolerance allows, as a table, JSON or a picture.

#include "arcs_command.h"

#include "Commands.h"
#include "Output_file.h"
#include "dxf/write_dxf.h"
#include "option_words.h"
#include "svg_paths.h"
#include "toolpath/order_passes.h"
#include "usage.h"
#include "written/write_plain_svg.h"

#include <CGAL/Bounding_arcs_2/chain/arc_chain.h>
#include "../study/slope_integral.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

namespace bounding_arcs_tool {
namespace {

namespace ba = CGAL::Bounding_arcs;

struct Fitted_curve {
  Curve_record record;
  std::size_t number_of_beziers = 0, number_of_spirals = 0;
  std::vector<std::size_t> beziers;  // of each spiral
  ba::Arc_chain chain;
  std::vector<std::size_t> last_beziers;  // of each arc, the one where it ends
  double least = 0;                       // N*: what no chain of this kind can go below as eps goes to 0
  double least_ms = 0, median_ms = 0;     // of fitting
};

// Twice the area of the curve closed by its chord, by its control polygon: positive if it runs counterclockwise.
bool is_counterclockwise(const Fitted_curve& curve) {
  double area = 0;
  const auto pieces = curve.record.bezier_pieces<double>();
  const Xy<double> origin = pieces.front().control_points().front();
  for (const auto& piece : pieces)
    for (std::size_t i = 0; i + 1 < piece.control_points().size(); ++i)
      area += cross(piece.control_points()[i] - origin, piece.control_points()[i + 1] - origin);
  return area >= 0;
}

ba::Arc_chain::Options chain_options(const Fitted_curve& curve, const Arcs_options& options) {
  ba::Arc_chain::Options result;
  result.continuity =
      options.continuity == "tangent" ? ba::Arc_chain::Continuity::TANGENT : ba::Arc_chain::Continuity::POSITION;
  result.max_arcs = options.max_arcs;
  if (options.side != "two")
    result.side = (options.side == "inner") == is_counterclockwise(curve) ? ba::Arc_chain::Side::LEFT
                                                                          : ba::Arc_chain::Side::RIGHT;
  return result;
}

using Spirals = std::vector<ba::Bezier_spiral_2<double>>;

double least_number(const Spirals& spirals, double eps, const ba::Arc_chain::Options& options) {
  namespace factor = ba::cubic_factor;
  const bool tangent = options.continuity == ba::Arc_chain::Continuity::TANGENT,
             two = options.side == ba::Arc_chain::Side::BOTH;
  const double f =
      tangent ? (two ? factor::BIARC : factor::ONE_SIDED_BIARC) : (two ? factor::ARC : factor::ONE_SIDED_ARC);
  double integral = 0;
  for (const auto& spiral : spirals) integral += ba::slope_integral(spiral);
  return (tangent ? 2 : 1) * std::cbrt(f / eps) * integral;
}

// Makes arcs of one circle one arc, up to half of it: pieces of curves cut them.
void join_arcs(Fitted_curve& curve, double eps) {
  constexpr double MOVE = 0x1p-44;  // of the chord: the guarantee of arc_of_both
  std::vector<ba::Arc_chain::Arc> arcs;
  for (const ba::Arc_chain::Arc& arc : curve.chain.arcs) {
    if (!arcs.empty() && arcs.back().to == arc.from)
      if (const std::optional<Arc_2> both = arc_of_both(arcs.back(), arc)) {
        ba::Arc_chain::Arc whole = arcs.back();
        static_cast<Arc_2&>(whole) = *both;
        whole.t1 = arc.t1;
        whole.error = (std::max)(whole.error, arc.error) +
                      MOVE * std::hypot(both->to.x - both->from.x, both->to.y - both->from.y);
        if (whole.error <= eps) {
          arcs.back() = whole;
          curve.last_beziers.back() = curve.beziers[arc.spiral];
          curve.chain.error = (std::max)(curve.chain.error, whole.error);
          continue;
        }
      }
    arcs.push_back(arc);
    curve.last_beziers.push_back(curve.beziers[arc.spiral]);
  }
  curve.chain.arcs = std::move(arcs);
}

Fitted_curve fit(const std::string& file, Curve_record&& record, double eps, const Arcs_options& options) {
  Fitted_curve curve;
  curve.record = std::move(record);
  const auto pieces = curve.record.bezier_pieces<double>();
  curve.number_of_beziers = pieces.size();
  Spirals spirals;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (auto& spiral : served(file, curve.record.name, [&] { return ba::spiral_segments(pieces[i]); })) {
      spirals.push_back(std::move(spiral));
      curve.beziers.push_back(i);
    }
  curve.number_of_spirals = spirals.size();
  const ba::Arc_chain::Options how = chain_options(curve, options);
  std::vector<double> times;
  for (std::size_t i = 0; i < (options.format == "table" ? options.repeat : 1); ++i) {
    const auto start = std::chrono::steady_clock::now();
    curve.chain = served(file, curve.record.name, [&] { return ba::arc_chain(spirals, eps, how); });
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(times.begin(), times.end());
  curve.least_ms = times.front();
  curve.median_ms = times[times.size() / 2];
  const std::string place = "curve \"" + curve.record.name + "\"";
  if (curve.chain.status == ba::Build_status::RESOLUTION_REACHED)
    throw Input_error(file, place, below_resolution(eps, curve.chain.error));
  if (curve.chain.status == ba::Build_status::REGION_LIMIT)
    throw Input_error(file, place,
                      "eps " + number(eps) + " needs more than " + std::to_string(options.max_arcs) +
                          " arcs; raise --max-arcs or eps");
  join_arcs(curve, eps);
  if (options.format == "table") curve.least = least_number(spirals, eps, how);  // takes longer than fitting
  return curve;
}

std::size_t last_bezier(const Fitted_curve& curve, const ba::Arc_chain::Arc& arc) {
  return curve.last_beziers[static_cast<std::size_t>(&arc - curve.chain.arcs.data())];
}

void write_json(std::ostream& out, const std::vector<Fitted_curve>& curves, double eps, const Arcs_options& options) {
  constexpr std::size_t LONG_TEXT = 1 << 16;  // bytes that are written at once
  out << "{\"eps\":" << number(eps) << ",\"continuity\":\"" << options.continuity << "\",\"side\":\"" << options.side
      << "\",\"curves\":[";
  const char* between_curves = "\n";
  for (const Fitted_curve& c : curves) {
    out << between_curves << "{\"name\":" << json_string(c.record.name) << ",\"beziers\":" << c.number_of_beziers
        << ",\"spirals\":" << c.number_of_spirals << ",\"arcs\":" << c.chain.arcs.size()
        << ",\"error\":" << number(c.chain.error) << ",\"pieces\":[";
    std::string text;
    Piece_text pieces;
    const char* separator = "\n{";
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) {
      text += separator;
      pieces.add_members(text, arc);
      text += ',';
      add_span_members(text, c.beziers[arc.spiral], arc.t0, arc.t1);
      if (last_bezier(c, arc) != c.beziers[arc.spiral])
        text += ",\"bezier_end\":" + std::to_string(last_bezier(c, arc));
      text += ",\"error\":";
      add_number(text, arc.error);
      text += '}';
      separator = ",\n{";
      if (text.size() < LONG_TEXT) continue;
      out << text;
      text.clear();
    }
    out << text << "]}";
    between_curves = ",\n";
  }
  out << "]}\n";
}

void write_csv(std::ostream& out, const std::vector<Fitted_curve>& curves) {
  out << "curve,bezier,t0,t1,bezier_end,error," << PIECE_COLUMNS << '\n';
  for (const Fitted_curve& c : curves)
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs)
      out << csv_field(c.record.name) << ',' << c.beziers[arc.spiral] << ',' << number(arc.t0) << ',' << number(arc.t1)
          << ',' << last_bezier(c, arc) << ',' << number(arc.error) << ',' << piece_fields(arc) << '\n';
}

void write_table(std::ostream& out, const std::vector<Fitted_curve>& curves, double eps) {
  std::size_t width = 5, beziers = 0, spirals = 0, arcs = 0;
  double least = 0, error = 0, least_ms = 0, median_ms = 0;
  for (const Fitted_curve& c : curves) width = (std::max)(width, table_name(c.record.name).size());
  char line[300];
  const auto row = [&](const std::string& name, std::size_t b, std::size_t s, std::size_t a, double n, double e,
                       double t0, double t) {
    std::snprintf(line, sizeof line, "%-*s %7zu %7zu %8zu %10.1f %11.4g %10.4f %10.4f\n", static_cast<int>(width),
                  name.c_str(), b, s, a, n, e, t0, t);
    out << line;
  };
  std::snprintf(line, sizeof line, "%-*s %7s %7s %8s %10s %11s %10s %10s\n", static_cast<int>(width), "curve",
                "beziers", "spirals", "arcs", "N*", "error", "min ms", "median ms");
  out << line;
  for (const Fitted_curve& c : curves) {
    row(table_name(c.record.name), c.number_of_beziers, c.number_of_spirals, c.chain.arcs.size(), c.least,
        c.chain.error, c.least_ms, c.median_ms);
    beziers += c.number_of_beziers;
    spirals += c.number_of_spirals;
    arcs += c.chain.arcs.size();
    least += c.least;
    error = (std::max)(error, c.chain.error);
    least_ms += c.least_ms;
    median_ms += c.median_ms;
  }
  if (curves.size() > 1) row("all", beziers, spirals, arcs, least, error, least_ms, median_ms);
  std::snprintf(line, sizeof line,
                "\nN* is the number that a chain of this kind comes near to as eps goes to 0, without what is lost at "
                "the ends of\n"
                "spiral segments. No arc is farther than error <= %s from its piece of the curve, which is certified.\n"
                "Times are of fitting, without reading and spiral segmentation.\n",
                number(eps).c_str());
  out << line;
}

void draw(std::ostream& out, const std::vector<Fitted_curve>& curves, double eps) {
  Box box;
  std::size_t arcs = 0;
  for (const Fitted_curve& c : curves) {
    arcs += c.chain.arcs.size();
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) {
      box.add(arc.from);
      box.add(arc.to);
      box.add(middle(arc));
    }
  }
  const bool flips =
      std::any_of(curves.begin(), curves.end(), [](const Fitted_curve& c) { return !c.record.y_is_down; });
  const Sheet sheet(box, flips);
  constexpr double DOT = 4.5;
  Dot_width dots;
  for (const Fitted_curve& c : curves)
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) dots.add(sheet.view, arc.from, arc.to);
  const std::string eps_text = short_number(eps);
  char text[900];
  std::snprintf(
      text, sizeof text,
      "<svg %s width=\"%.0f\" height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
      "<title>eps %s: %zu arcs</title>\n"
      "<style>path{fill:none;stroke-linejoin:round}.c,.a{vector-effect:non-scaling-stroke}\n"
      ".c{stroke:#bbb;stroke-width:4}\n.a{stroke:#0072b2;stroke-width:1.2}\n"
      ".e{stroke:#c0182b;stroke-width:%.3g;stroke-linecap:round}</style>\n"
      "<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n"
      "<text x=\"%.0f\" y=\"36\" font-family=\"sans-serif\" font-size=\"20\" fill=\"#333\">eps %s: %zu arcs</text>\n"
      "<text x=\"%.0f\" y=\"58\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#777\">grey: the curve; dots: "
      "ends of arcs</text>\n",
      SVG_NAMESPACES, sheet.width, sheet.height, sheet.width, sheet.height, eps_text.c_str(), arcs, dots(DOT),
      Sheet::MARGIN, eps_text.c_str(), arcs, Sheet::MARGIN);
  out << text;
  // a layer, with a path for each curve
  const auto layer = [&](const char* name, const char* kind, const auto& path_of) {
    out << layer_start(name);
    for (const Fitted_curve& c : curves)
      out << "<g><title>" << escaped(c.record.name) << "</title>\n<path class=\"" << kind << "\" d=\"" << path_of(c)
          << "\"/></g>\n";
    out << "</g>\n";
  };
  layer("curves", "c", [&](const Fitted_curve& c) {
    std::string path;
    for (const auto& piece : c.record.bezier_pieces<double>()) path += curve_path(sheet.view, piece);
    return path;
  });
  layer("arcs", "a", [&](const Fitted_curve& c) {
    Xy<double> last = c.chain.arcs.front().from;
    std::string path = "M" + sheet.view(last);
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) {
      if (arc.from != last) path += "M" + sheet.view(arc.from);
      path += step(sheet.view, arc, true);
      last = arc.to;
    }
    return path;
  });
  layer("ends", "e", [&](const Fitted_curve& c) {
    std::string path = "M" + sheet.view(c.chain.arcs.front().from) + "h0";
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) path += "M" + sheet.view(arc.to) + "h0";
    return path;
  });
  out << "</svg>\n";
}

bool is_y_down(const std::vector<Fitted_curve>& curves) {
  return std::all_of(curves.begin(), curves.end(), [](const auto& c) { return c.record.y_is_down; });
}

Written_drawing written(const std::vector<Fitted_curve>& curves, const File_unit& unit,
                        const std::optional<ba::Curve_file::Page>& page) {
  Written_drawing drawing;
  drawing.y_is_down = is_y_down(curves);
  drawing.unit_in_mm = unit.in_mm;
  drawing.page = page;
  for (const Fitted_curve& c : curves) {
    drawing.curves.push_back({c.record.name, look_of(c.record), {}});
    for (const ba::Arc_chain::Arc& arc : c.chain.arcs) add_piece(drawing.curves.back().pieces, arc);
  }
  return drawing;
}

// A pass a curve.
std::vector<Tool_pass> tool_passes(const std::vector<Fitted_curve>& curves, double depth) {
  std::vector<Tool_pass> passes;
  for (const Fitted_curve& c : curves) {
    const std::vector<Arc_2> arcs(c.chain.arcs.begin(), c.chain.arcs.end());
    for (Tool_pass& pass : passes_of("curve " + c.record.name, -depth, arcs)) passes.push_back(std::move(pass));
  }
  return inside_out(passes);
}

// The rule of a DXF file is not that of SVG, which plays a part where closed curves are within others.
void tell_of_rule(const std::string& file, ba::Fill_rule rule, std::size_t closed) {
  if (rule == ba::Fill_rule::EVEN_ODD && closed > 1)
    tell(file, "its rule is evenodd, which is not that of plain SVG: read that with --rule evenodd");
}

}  // namespace

CLI::App* add_arcs_command(CLI::App& app, Arcs_options& options) {
  CLI::App* arcs = app.add_subcommand("arcs", "Approximate curves by few circular arcs within a tolerance");
  arcs->add_option("FILES", options.files, "Curve files, JSON, SVG or DXF; - reads standard input")->required();
  add_reading_options(*arcs, options.reading);
  arcs->add_option("--eps", options.eps, "Largest distance between an arc and the curve, in units of the coordinates")
      ->required()
      ->check(CLI::Validator(check_tolerance, "", "eps"))
      ->type_name("NUMBER");
  arcs->add_option("--continuity", options.continuity,
                   "tangent: biarcs, without kinks where the curve has none; position: fewer arcs")
      ->check(one_of({"tangent", "position"}))
      ->capture_default_str();
  arcs->add_option("--side", options.side,
                   "Where the chain may run; inner is the inside of a closed curve, of an open one closed by its chord")
      ->check(one_of({"two", "inner", "outer"}))
      ->capture_default_str();
  add_output(*arcs, {"table", "json", "csv", "svg", "dxf", "gcode"}, options.format, options.output);
  add_plain(*arcs, options.is_plain);
  add_dxf_entities(*arcs, options.dxf);
  add_gcode_options(*arcs, options.gcode, true);
  add_stream_options(*arcs, options.stream, options.format);
  arcs->add_option("--repeat", options.repeat,
                   "For the table, fit each curve this often; the least and the median time are shown")
      ->check(whole_number_in(1, 1000000))
      ->capture_default_str();
  arcs->add_option("--max-arcs", options.max_arcs, "Give up above this number of arcs a curve")
      ->check(whole_number_in(1, 4'000'000'000))
      ->capture_default_str();
  arcs->footer(
      "G-code has a pass a curve; what lies in a closed one comes first, and then what starts nearest to the tool.\n"
      "Examples:\n"
      "  bounding_arcs arcs --eps 1e-5 examples/data/*.json\n"
      "  bounding_arcs arcs --eps 1e-3 --continuity position --format json curve.json -o arcs.json\n"
      "  bounding_arcs arcs --eps 0.01 --side outer --format svg drawing.svg -o picture.svg\n"
      "  bounding_arcs arcs --eps 0.01 drawing.svg --plain -o drawing_of_arcs.svg\n"
      "  bounding_arcs arcs --eps 0.01 --units mm --format dxf drawing.svg -o drawing.dxf\n"
      "  bounding_arcs arcs --eps 0.01 --format dxf --dxf-entities arcs drawing.svg -o drawing.dxf\n"
      "  bounding_arcs arcs --eps 0.01 --feed 600 --depth 1 drawing.dxf -o drawing.nc\n"
      "  bounding_arcs arcs --eps 0.01 --stream --jobs 8 records.jsonl -o results.jsonl\n");
  return arcs;
}

int run_arcs(const Arcs_options& options) {
  check_inputs(options.files);
  const bool is_gcode = options.format == "gcode";
  if (is_gcode) check_gcode_words(options.gcode);
  const double eps = std::strtod(options.eps.c_str(), nullptr);
  if (options.stream.is_on) {
    const auto answer = [&](std::vector<Curve_record>&& records, std::ostream& out) {
      std::vector<Fitted_curve> curves;
      for (Curve_record& record : records) curves.push_back(fit(RECORD_NAME, std::move(record), eps, options));
      write_json(out, curves, eps, options);
    };
    return run_stream(options.stream, options.files.front(), options.output, answer);
  }
  check_plain(options.is_plain, options.format);
  std::vector<Fitted_curve> curves;
  Reading_words reading = options.reading;
  std::optional<ba::Curve_file::Page> page;
  for (const std::string& file : options.files) {
    ba::Curve_file read = read_told(file, reading);
    reading.keep_unit({name_of_file(file), read.unit_in_mm});
    if (!page) page = read.page;
    if (options.is_plain)
      tell_of_rule(name_of_file(file), read.rule,
                   static_cast<std::size_t>(std::count_if(read.curves.begin(), read.curves.end(),
                                                          [](const Curve_record& r) { return r.closed; })));
    Progress_line progress("fitting arcs, curves");
    for (std::size_t i = 0; i < read.curves.size(); ++i) {
      progress(i, read.curves.size());
      curves.push_back(fit(name_of_file(file), std::move(read.curves[i]), eps, options));
    }
  }
  if (options.format == "dxf") tell_units_of_dxf(reading.unit);
  const File_unit unit =
      reading.unit.file.empty() ? File_unit{name_of_file(options.files.front()), reading.unit.in_mm} : reading.unit;
  const Gcode_setup setup = is_gcode ? gcode_setup(options.gcode, unit, is_y_down(curves)) : Gcode_setup{};
  Output_file output(options.output);
  if (options.format == "json") write_json(output.stream(), curves, eps, options);
  else if (options.is_plain) write_plain_svg(output.stream(), written(curves, reading.unit, page));
  else if (options.format == "svg") draw(output.stream(), curves, eps);
  else if (options.format == "dxf")
    write_dxf(output.stream(), written(curves, reading.unit, page), dxf_entities(options.dxf));
  else if (options.format == "csv") write_csv(output.stream(), curves);
  else if (is_gcode) write_gcode(output.stream(), unit.file, tool_passes(curves, setup.depth), setup);
  else write_table(output.stream(), curves, eps);
  output.commit();
  return 0;
}

}  // namespace bounding_arcs_tool
