// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sections and tables are those that dxflib's manual names as the least that CAD programs ask for.

#include "write_dxf.h"

#include "../Commands.h"

#include <dxflib/dl_dxf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>

namespace bounding_arcs_tool {
namespace {

// Writes to a stream, and numbers as they are written elsewhere: dxflib has a fixed number of them behind the point.
class Stream_writer : public DL_WriterA {
 public:
  explicit Stream_writer(std::ostream& out) : DL_WriterA("/dev/null"), out_(out) {}
  void dxfReal(int code, double value) const override { dxfString(code, number(value)); }
  void dxfInt(int code, int value) const override { dxfString(code, std::to_string(value)); }
  void dxfHex(int code, int value) const override {
    char text[20];
    std::snprintf(text, sizeof text, "%X", static_cast<unsigned>(value));
    dxfString(code, text);
  }
  void dxfString(int code, const char* value) const override { out_ << code << '\n' << value << '\n'; }
  void dxfString(int code, const std::string& value) const override { dxfString(code, value.c_str()); }

 private:
  std::ostream& out_;
};

std::string layer_name(const std::string& text) {
  constexpr std::size_t LONGEST = 255;
  const std::string forbidden = "<>/\\\":;?*|=`,";
  std::string name;
  for (const char c : text.substr(0, LONGEST))
    name += c > ' ' && c < 0x7f && forbidden.find(c) == std::string::npos ? c : '_';
  return name.empty() ? "0" : name;
}

DL_Attributes on_layer(const std::string& layer) { return {layer, 256, -1, "BYLAYER", 1.0}; }

void write_tables(DL_Dxf& dxf, DL_WriterA& writer, const std::set<std::string>& layers) {
  writer.sectionTables();
  dxf.writeVPort(writer);
  writer.tableLinetypes(3);
  for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"})
    dxf.writeLinetype(writer, DL_LinetypeData(name, name, 0, 0, 0.0));
  writer.tableEnd();
  writer.tableLayers(static_cast<int>(layers.size()));
  for (const std::string& layer : layers)
    dxf.writeLayer(writer, DL_LayerData(layer, 0), DL_Attributes("", DL_Codes::black, -1, "CONTINUOUS", 1.0));
  writer.tableEnd();
  writer.tableStyle(1);
  dxf.writeStyle(writer, DL_StyleData("Standard", 0, 0.0, 1.0, 0.0, 0, 2.5, "txt", ""));
  writer.tableEnd();
  dxf.writeView(writer);
  dxf.writeUcs(writer);
  writer.tableAppid(1);
  dxf.writeAppid(writer, "ACAD");
  writer.tableEnd();
  dxf.writeDimStyle(writer, 1, 1, 1, 1, 1);
  dxf.writeBlockRecord(writer);
  writer.tableEnd();
  writer.sectionEnd();
  writer.sectionBlocks();
  for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
    dxf.writeBlock(writer, DL_BlockData(name, 0, 0.0, 0.0, 0.0));
    dxf.writeEndBlock(writer, name);
  }
  writer.sectionEnd();
}

void write_polyline(DL_Dxf& dxf, DL_WriterA& writer, const std::string& layer, const Arc_2* first, const Arc_2* last,
                    bool y_is_down) {
  constexpr int CLOSED = 1;
  const double sign = y_is_down ? -1 : 1;
  const bool is_closed = last[-1].to == first->from;
  const auto vertex = [&](const Xy<double>& p, double bulge) {
    dxf.writeVertex(writer, DL_VertexData(p.x, sign * p.y, 0, sign * bulge));
  };
  const int count = static_cast<int>(last - first) + (is_closed ? 0 : 1);
  dxf.writePolyline(writer, DL_PolylineData(count, 0, 0, is_closed ? CLOSED : 0), on_layer(layer));
  for (const Arc_2* piece = first; piece != last; ++piece) vertex(piece->from, piece->bulge);
  if (!is_closed) vertex(last[-1].to, 0);
  dxf.writePolylineEnd(writer);
}

// The piece as an ARC, if it has the piece's ends. Its circle is that of circle_of, which asks for more.
std::optional<DL_ArcData> arc_of(const Arc_2& piece, double sign) {
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
  return DL_ArcData(center.x, center.y, 0, radius, is_ccw ? from : to, is_ccw ? to : from);
}

// Two halves of a circle, which is what offsets have for one.
bool is_circle(const Arc_2* first, const Arc_2* last) {
  return last - first == 2 && first[0].from == first[1].to && first[0].to == first[1].from &&
         std::fabs(first[0].bulge) == 1 && first[0].bulge == first[1].bulge;
}
void write_circle(DL_Dxf& dxf, DL_WriterA& writer, const std::string& layer, const Arc_2& half, bool y_is_down) {
  const double radius = std::hypot(half.to.x / 2 - half.from.x / 2, half.to.y / 2 - half.from.y / 2);
  const Xy<double> center{half.from.x / 2 + half.to.x / 2, half.from.y / 2 + half.to.y / 2};
  dxf.writeCircle(writer, DL_CircleData(center.x, y_is_down ? -center.y : center.y, 0, radius), on_layer(layer));
}

void write_piece(DL_Dxf& dxf, DL_WriterA& writer, const std::string& layer, const Arc_2& piece, bool y_is_down) {
  const double sign = y_is_down ? -1 : 1;
  if (piece.bulge == 0) {
    dxf.writeLine(writer, DL_LineData(piece.from.x, sign * piece.from.y, 0, piece.to.x, sign * piece.to.y, 0),
                  on_layer(layer));
  } else if (const std::optional<DL_ArcData> arc = arc_of(piece, sign)) {
    dxf.writeArc(writer, *arc, on_layer(layer));
  } else {
    write_polyline(dxf, writer, layer, &piece, &piece + 1, y_is_down);
  }
}

}  // namespace

void write_dxf(std::ostream& out, const std::vector<Dxf_chain>& chains, bool y_is_down, Dxf_entities entities) {
  Stream_writer writer(out);
  DL_Dxf dxf;
  std::set<std::string> layers{"0"};
  for (const Dxf_chain& chain : chains) layers.insert(layer_name(chain.layer));
  dxf.writeHeader(writer);
  writer.sectionEnd();
  write_tables(dxf, writer, layers);
  writer.sectionEntities();
  for (const Dxf_chain& chain : chains) {
    const std::string layer = layer_name(chain.layer);
    const Arc_2 *first = chain.pieces.data(), *const end = first + chain.pieces.size();
    while (first != end) {
      const Arc_2* last = first + 1;
      while (last != end && last->from == last[-1].to) ++last;
      if (is_circle(first, last)) {
        write_circle(dxf, writer, layer, *first, y_is_down);
      } else if (entities == Dxf_entities::ARCS) {
        for (const Arc_2* piece = first; piece != last; ++piece) write_piece(dxf, writer, layer, *piece, y_is_down);
      } else {
        write_polyline(dxf, writer, layer, first, last, y_is_down);
      }
      first = last;
    }
  }
  writer.sectionEnd();
  dxf.writeObjects(writer);
  dxf.writeObjectsEnd(writer);
  writer.dxfEOF();
}

}  // namespace bounding_arcs_tool
