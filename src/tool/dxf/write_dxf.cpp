// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sections and tables are those that dxflib's manual names as the least that CAD programs ask for.

#include "write_dxf.h"

#include "../../input/Dxf_groups.h"
#include "../../input/Dxf_text.h"
#include "../../input/Dxf_units.h"
#include "../../input/Input_text.h"
#include "../Commands.h"
#include "../written/colour_numbers.h"

#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace bounding_arcs_tool {
namespace {

// Writes to a stream, and numbers as they are written elsewhere: dxflib has a fixed number of them behind the point.
class Stream_writer : public DL_WriterA {
 public:
  explicit Stream_writer(std::ostream& out) : DL_WriterA("/dev/null"), out_(out) {}
  void dxfReal(int code, double value) const override { write(code, number(value)); }
  void dxfInt(int code, int value) const override { write(code, std::to_string(value)); }
  void dxfHex(int code, int value) const override {
    char text[20];
    std::snprintf(text, sizeof text, "%X", static_cast<unsigned>(value));
    write(code, text);
  }
  void dxfString(int code, const char* value) const override { write(code, value); }
  void dxfString(int code, const std::string& value) const override { write(code, dxf_as_ascii(value)); }

 private:
  void write(int code, std::string_view value) const { out_ << code << '\n' << value << '\n'; }

  std::ostream& out_;
};

bool is_within_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }  // of UTF-8

std::string layer_name(const std::string& text) {
  constexpr std::size_t LONGEST = 255;
  constexpr std::string_view FORBIDDEN = "<>/\\\":;?*|=`,";
  std::string name = valid_utf8(text);
  if (name.size() > LONGEST) {
    std::size_t size = LONGEST;
    while (is_within_character(name[size])) --size;
    name.resize(size);
  }
  for (char& c : name)
    if ((c >= 0 && c < ' ') || c == 0x7f || FORBIDDEN.find(c) != FORBIDDEN.npos) c = '_';
  if (name.empty()) return "0";
  for (char* c : {&name.front(), &name.back()})
    if (*c == ' ') *c = '_';  // readers take blanks there for nothing
  return name;
}

std::string layer_of(const Written_curve& curve) {
  return layer_name(curve.look.layer.empty() ? curve.name : curve.look.layer);
}

using CGAL::Bounding_arcs::Curve_record;
using Layers = std::map<std::string, Curve_record::Colour>;

// With a number for programs that know no others.
Curve_record::Colour dxf_colour(Curve_record::Colour colour) {
  constexpr int BLACK_OR_WHITE = 7, BLACK = 0, WHITE = 0xFFFFFF;
  if (colour.number == 0 && (colour.rgb == BLACK || colour.rgb == WHITE)) colour.rgb = -1;
  if (colour.number == 0) colour.number = colour.rgb < 0 ? BLACK_OR_WHITE : colour_number_of_rgb(colour.rgb);
  return colour;
}

DL_Attributes attributes_of(const Written_curve& curve, const Layers& layers) {
  constexpr int BY_LAYER = 256;
  const std::string layer = layer_of(curve);
  const Curve_record::Colour colour = dxf_colour(curve.look.colour);
  if (layers.at(layer) == colour) return {layer, BY_LAYER, -1, "BYLAYER", 1.0};
  return {layer, colour.number, colour.rgb, -1, "BYLAYER"};
}

// Handles of what comes later are below the seed, which is where programs go on.
void write_header(DL_WriterA& writer, double unit_in_mm) {
  writer.sectionHeader();
  writer.dxfString(9, "$ACADVER");
  writer.dxfString(1, "AC1015");
  writer.dxfString(9, "$HANDSEED");
  writer.dxfString(5, "FFFFFFF");
  if (const int number = dxf_number_of_unit(unit_in_mm); number > 0) {
    writer.dxfString(9, "$INSUNITS");
    writer.dxfInt(70, number);
  }
  writer.sectionEnd();
}

// The root of objects and the list of groups, each with its owner.
void write_objects(DL_WriterA& writer) {
  constexpr int ROOT = 0xC, GROUPS = 0xD;
  const auto dictionary = [&](int handle, int owner) {
    writer.dxfString(0, "DICTIONARY");
    writer.dxfHex(5, handle);
    writer.dxfHex(330, owner);
    writer.dxfString(100, "AcDbDictionary");
    writer.dxfInt(281, 1);
  };
  writer.sectionObjects();
  dictionary(ROOT, 0);
  writer.dxfString(3, "ACAD_GROUP");
  writer.dxfHex(350, GROUPS);
  dictionary(GROUPS, ROOT);
  writer.sectionEnd();
}

void write_tables(DL_Dxf& dxf, DL_WriterA& writer, const Layers& layers) {
  constexpr int BLOCK_RECORDS = 1;  // a handle
  constexpr const char* SPACES[] = {"*Model_Space", "*Paper_Space"};
  writer.sectionTables();
  dxf.writeVPort(writer);
  writer.tableLinetypes(3);
  for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"})
    dxf.writeLinetype(writer, DL_LinetypeData(name, name, 0, 0, 0.0));
  writer.tableEnd();
  writer.tableLayers(static_cast<int>(layers.size()));
  for (const auto& [layer, colour] : layers)
    dxf.writeLayer(writer, DL_LayerData(layer, 0), DL_Attributes("", colour.number, colour.rgb, -1, "CONTINUOUS"));
  writer.tableEnd();
  writer.tableStyle(1);
  dxf.writeStyle(writer, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  writer.tableEnd();
  dxf.writeView(writer);
  dxf.writeUcs(writer);
  writer.tableAppid(2);
  for (const char* name : {"ACAD", DXF_NAMES}) dxf.writeAppid(writer, name);
  writer.tableEnd();
  dxf.writeDimStyle(writer, 1, 1, 1, 1, 1);
  writer.table("BLOCK_RECORD", 2, BLOCK_RECORDS);
  for (const char* name : SPACES) {
    writer.entity("BLOCK_RECORD");
    writer.dxfHex(330, BLOCK_RECORDS);
    writer.subClass("AcDbSymbolTableRecord");
    writer.subClass("AcDbBlockTableRecord");
    writer.dxfString(2, name);
  }
  writer.tableEnd();
  writer.sectionEnd();
  writer.sectionBlocks();
  for (const char* name : SPACES) {
    dxf.writeBlock(writer, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(writer, name);
  }
  writer.sectionEnd();
}

// Where entities go, and how: y of what is written is the sign times that of the drawing.
struct Entity_target {
  DL_Dxf& dxf;
  DL_WriterA& writer;
  DL_Attributes attributes;
  double sign;
  double height;     // z
  std::string name;  // of the curve, where its layer does not tell it
};

// DXF has no place for names but extended data of programs.
void write_name(const Entity_target& target) {
  constexpr std::size_t LONGEST = 255;
  if (target.name.empty()) return;
  target.writer.dxfString(1001, DXF_NAMES);
  target.writer.dxfString(1000, one_line(target.name, LONGEST));
}

void write_polyline(const Entity_target& target, const Arc_2* first, const Arc_2* last) {
  constexpr int CLOSED = 1;
  const auto& [dxf, writer, attributes, sign, height, name] = target;
  const bool is_closed = last[-1].to == first->from;
  const auto vertex = [to = &target](const Xy<double>& p, double bulge) {
    to->dxf.writeVertex(to->writer, DL_VertexData(p.x, to->sign * p.y, 0, to->sign * bulge));
  };
  const int count = static_cast<int>(last - first) + (is_closed ? 0 : 1);
  dxf.writePolyline(writer, DL_PolylineData(count, 0, 0, is_closed ? CLOSED : 0), attributes);
  if (height != 0) writer.dxfReal(38, height);  // which dxflib leaves out
  for (const Arc_2* piece = first; piece != last; ++piece) vertex(piece->from, piece->bulge);
  if (!is_closed) vertex(last[-1].to, 0);
  dxf.writePolylineEnd(writer);
  write_name(target);
}

// dxflib has polylines of two dimensions only.
void write_polyline_3d(const Entity_target& target, const Written_curve& curve) {
  constexpr int IS_3D = 8, VERTEX_IS_3D = 32;
  const DL_WriterA& writer = target.writer;
  const auto begin = [&](const char* entity) {
    writer.entity(entity);
    writer.subClass("AcDbEntity");
    writer.entityAttributes(target.attributes);
  };
  const auto place = [&](const Xy<double>& p, double z) {
    writer.dxfReal(10, p.x);
    writer.dxfReal(20, 0 + target.sign * p.y);  // no -0
    writer.dxfReal(30, z);
  };
  begin("POLYLINE");
  writer.subClass("AcDb3dPolyline");
  writer.dxfInt(66, 1);
  place({0, 0}, 0);
  writer.dxfInt(70, IS_3D);
  for (std::size_t i = 0; i < curve.heights.size(); ++i) {
    begin("VERTEX");
    writer.subClass("AcDbVertex");
    writer.subClass("AcDb3dPolylineVertex");
    place(i < curve.pieces.size() ? start_of(curve.pieces[i]) : end_of(curve.pieces.back()), curve.heights[i]);
    writer.dxfInt(70, VERTEX_IS_3D);
  }
  begin("SEQEND");
}

// The piece as an ARC, if it has the piece's ends. Its circle is that of circle_of, which asks for more.
std::optional<DL_ArcData> arc_of(const Arc_2& piece, double sign, double height) {
  constexpr double DEGREES = 57.29577951308232, ALLOWED = 0x1p-30;
  const double b = sign * piece.bulge;
  const Xy<double> start{piece.from.x, sign * piece.from.y}, end{piece.to.x, sign * piece.to.y};
  const double chord = std::hypot(end.x - start.x, end.y - start.y);
  const double radius = chord * (1 + b * b) / (4 * std::fabs(b));
  const Xy<double> center = 0.5 * (start + end) + ((1 - b) * (1 + b) / (4 * b)) * perp(end - start);
  bool is_exact = true;
  const auto angle = [&](const Xy<double>& p) {
    const double degrees = DEGREES * std::atan2(p.y - center.y, p.x - center.x), turn = degrees / DEGREES;
    const double miss = std::hypot(center.x + radius * std::cos(turn) - p.x, center.y + radius * std::sin(turn) - p.y);
    is_exact = is_exact && miss <= ALLOWED * chord;  // false for what is no number
    return degrees < 0 ? degrees + 360 : degrees;
  };
  const double from = angle(start), to = angle(end);
  if (!is_exact) return std::nullopt;
  const bool is_ccw = b > 0;  // as all arcs of DXF are
  return DL_ArcData(center.x, center.y, height, radius, is_ccw ? from : to, is_ccw ? to : from);
}

// Two halves of a circle, which is what offsets have for one.
bool is_circle(const Arc_2* first, const Arc_2* last) {
  return last - first == 2 && first[0].from == first[1].to && first[0].to == first[1].from &&
         std::fabs(first[0].bulge) == 1 && first[0].bulge == first[1].bulge;
}
void write_circle(const Entity_target& target, const Arc_2& half) {
  const double radius = std::hypot(half.to.x / 2 - half.from.x / 2, half.to.y / 2 - half.from.y / 2);
  const Xy<double> center{half.from.x / 2 + half.to.x / 2, half.from.y / 2 + half.to.y / 2};
  target.dxf.writeCircle(target.writer, DL_CircleData(center.x, target.sign * center.y, target.height, radius),
                         target.attributes);
  write_name(target);
}

void write_piece(const Entity_target& target, const Arc_2& piece) {
  const double sign = target.sign, z = target.height;
  if (piece.bulge == 0) {
    target.dxf.writeLine(target.writer,
                         DL_LineData(piece.from.x, sign * piece.from.y, z, piece.to.x, sign * piece.to.y, z),
                         target.attributes);
    write_name(target);
  } else if (const std::optional<DL_ArcData> arc = arc_of(piece, sign, z)) {
    target.dxf.writeArc(target.writer, *arc, target.attributes);
    write_name(target);
  } else {
    write_polyline(target, &piece, &piece + 1);
  }
}

void write_arcs(const Entity_target& target, const std::vector<Arc_2>& arcs, Dxf_entities entities) {
  const Arc_2 *const first = arcs.data(), *const last = first + arcs.size();
  if (is_circle(first, last)) return write_circle(target, *first);
  if (entities == Dxf_entities::POLYLINES) return write_polyline(target, first, last);
  for (const Arc_2& piece : arcs) write_piece(target, piece);
}

using Beziers = std::vector<Bezier_curve_2<double>>;

// A knot at each joint, as often as the degree; each piece's weights are scaled to start with the end of the one
// before.
void write_spline(const Entity_target& target, const Beziers& beziers) {
  const DL_WriterA& writer = target.writer;
  constexpr int CLOSED = 1, HAS_WEIGHTS = 4, PLANAR = 8;
  const int degree = beziers.front().degree(), pieces = static_cast<int>(beziers.size());
  const bool is_rational = std::any_of(beziers.begin(), beziers.end(), [](const auto& b) { return b.is_rational(); });
  const bool is_closed = beziers.front().control_points().front() == beziers.back().control_points().back();
  writer.entity("SPLINE");
  writer.subClass("AcDbEntity");
  writer.entityAttributes(target.attributes);
  writer.subClass("AcDbSpline");
  for (const auto& [code, value] : {std::pair(210, 0.0), std::pair(220, 0.0), std::pair(230, 1.0)})
    writer.dxfReal(code, value);
  writer.dxfInt(70, PLANAR + (is_rational ? HAS_WEIGHTS : 0) + (is_closed ? CLOSED : 0));
  writer.dxfInt(71, degree);
  writer.dxfInt(72, (pieces + 1) * degree + 2);
  writer.dxfInt(73, pieces * degree + 1);
  writer.dxfInt(74, 0);
  writer.dxfReal(40, 0);
  for (int knot = 0; knot <= pieces; ++knot)
    for (int i = 0; i < degree; ++i) writer.dxfReal(40, knot);
  writer.dxfReal(40, pieces);
  double factor = 1 / beziers.front().weight(0);
  for (std::size_t k = 0; is_rational && k < beziers.size(); ++k) {
    if (k > 0) factor *= beziers[k - 1].weight(degree) / beziers[k].weight(0);
    for (int i = k > 0 ? 1 : 0; i <= degree; ++i) writer.dxfReal(41, factor * beziers[k].weight(i));
  }
  for (std::size_t k = 0; k < beziers.size(); ++k)
    for (std::size_t i = k > 0 ? 1 : 0; i <= static_cast<std::size_t>(degree); ++i) {
      const Xy<double>& p = beziers[k].control_points()[i];
      writer.dxfReal(10, p.x);
      writer.dxfReal(20, target.sign * p.y);
      writer.dxfReal(30, target.height);
    }
  write_name(target);
}

// Writes the first pieces that make one entity, or entities of arcs, and returns where they end.
const Written_piece* write_entity(const Entity_target& target, const Written_piece* first, const Written_piece* last,
                                  Dxf_entities entities) {
  std::vector<Arc_2> arcs;
  Beziers beziers;
  for (; first != last; ++first) {
    const auto* const arc = std::get_if<Arc_2>(first);
    if (arc != nullptr ? !beziers.empty() : !arcs.empty()) break;
    if (arc != nullptr) {
      arcs.push_back(*arc);
      continue;
    }
    const auto& bezier = std::get<Bezier_curve_2<double>>(*first);
    if (!beziers.empty() && bezier.degree() != beziers.back().degree()) break;
    beziers.push_back(bezier);
  }
  if (arcs.empty()) write_spline(target, beziers);
  else write_arcs(target, arcs, entities);
  return first;
}

}  // namespace

void write_dxf(std::ostream& out, const Written_drawing& drawing, Dxf_entities entities) {
  Stream_writer writer(out);
  DL_Dxf dxf;
  Layers layers;
  for (const Written_curve& curve : drawing.curves) layers.try_emplace(layer_of(curve), dxf_colour(curve.look.colour));
  layers.try_emplace("0", dxf_colour({}));
  write_header(writer, drawing.unit_in_mm);
  write_tables(dxf, writer, layers);
  writer.sectionEntities();
  for (const Written_curve& curve : drawing.curves) {
    const Entity_target target{dxf,
                               writer,
                               attributes_of(curve, layers),
                               drawing.y_is_down ? -1.0 : 1.0,
                               curve.height,
                               curve.name == layer_of(curve) ? "" : curve.name};
    if (!curve.heights.empty()) {
      write_polyline_3d(target, curve);
      continue;
    }
    for_each_run(curve.pieces, [&](const Written_piece* first, const Written_piece* last) {
      while (first != last) first = write_entity(target, first, last, entities);
    });
  }
  writer.sectionEnd();
  write_objects(writer);
  writer.dxfEOF();
}

}  // namespace bounding_arcs_tool
