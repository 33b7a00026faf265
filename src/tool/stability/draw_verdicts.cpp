// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// bounding_arcs stability --verdicts: predicates on neighbouring doubles, counted or drawn, rounded figures at the
// left.

#include "Study_table.h"
#include "study_stability.h"

#include <CGAL/Bounding_arcs_2/study/Verdict_grid.h>

namespace bounding_arcs_tool {
namespace {

using CGAL::Bounding_arcs::Verdict_grid;
using CGAL::Bounding_arcs::verdict_grids;

constexpr std::size_t GRID_SIZE = 256;                       // doubles a side
constexpr int GRID_LEFT = 20, GRID_TOP = 84, GRID_GAP = 30;  // pixels
constexpr int GRID_ROW = static_cast<int>(GRID_SIZE) + 62;

struct Panel_words {
  const char *name, *naive, *ours, *plus, *zero, *minus;
};
const Panel_words PANEL_WORDS[] = {
    {"side of arc", "center and radius", "contact form, filtered", "left", "on the arc", "right"},
    {"tangency", "distance of centers", "squares, filtered", "apart", "touching", "crossing"},
    {"point location", "bisection", "winding number, certified", "outside", "on the curve", "inside"}};

// One path a verdict, of runs in rows. \param classes of the verdicts -1, 0 and 1
void draw_panel(std::ostream& out, const std::vector<signed char>& verdicts, const char* const (&classes)[3]) {
  for (int verdict = -1; verdict <= 1; ++verdict) {
    std::string path;
    for (std::size_t row = 0; row < GRID_SIZE; ++row)
      for (std::size_t column = 0, end = 0; column < GRID_SIZE; column = end) {
        const signed char here = verdicts[row * GRID_SIZE + column];
        for (end = column + 1; end < GRID_SIZE && verdicts[row * GRID_SIZE + end] == here; ++end) {
        }
        if (here == verdict)
          path += "M" + std::to_string(column) + " " + std::to_string(GRID_SIZE - 1 - row) + "h" +
                  std::to_string(end - column);
      }
    if (!path.empty()) out << "<path class=\"" << classes[verdict + 1] << "\" d=\"" << path << "\"/>\n";
  }
}

}  // namespace

Study_table verdict_table() {
  Study_table table{{"predicate", "points", "wrong verdicts"}};
  for (const Verdict_grid& grid : verdict_grids(GRID_SIZE))
    table.rows.push_back({grid.name, std::to_string(grid.ours.size()), std::to_string(grid.differences())});
  return table;
}

void draw_verdicts(std::ostream& out) {
  const std::vector<Verdict_grid> grids = verdict_grids(GRID_SIZE);
  const int width = 2 * (GRID_LEFT + static_cast<int>(GRID_SIZE)) + GRID_GAP,
            height = GRID_TOP + GRID_ROW * static_cast<int>(grids.size());
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
      << "\" viewBox=\"0 0 " << width << ' ' << height
      << "\">\n<title>Verdicts on neighbouring doubles</title>\n"
         "<style>text{font-family:sans-serif;font-size:12px;fill:#333}.h{font-size:18px}\n"
         "path{fill:none;shape-rendering:crispEdges}.p{stroke:#9ecae1}.m{stroke:#fdae6b}.z{stroke:#111}\n"
         "rect{fill:none;stroke:#888}</style>\n<rect width=\"100%\" height=\"100%\" style=\"fill:#fff;stroke:none\"/>\n"
      << "<text class=\"h\" x=\"" << GRID_LEFT << "\" y=\"32\">Verdicts on " << GRID_SIZE << " x " << GRID_SIZE
      << " neighbouring doubles</text>\n<text x=\"" << GRID_LEFT
      << "\" y=\"54\">Left: rounded figures are believed. Right: this library, which is exact.</text>\n";
  const char* const classes[] = {"m", "z", "p"};
  int y = GRID_TOP;
  for (const Verdict_grid& grid : grids) {
    for (const Panel_words& words : PANEL_WORDS) {
      if (grid.name != words.name) continue;
      const int right = GRID_LEFT + static_cast<int>(GRID_SIZE) + GRID_GAP;
      for (const bool is_naive : {true, false}) {
        const int x = is_naive ? GRID_LEFT : right;
        out << "<text x=\"" << x << "\" y=\"" << y - 6 << "\">" << words.name << ": "
            << (is_naive ? words.naive : words.ours) << "</text>\n<g transform=\"translate(" << x << ' ' << y
            << ")\"><g transform=\"translate(0 .5)\">\n";
        draw_panel(out, is_naive ? grid.naive : grid.ours, classes);
        out << "</g><rect width=\"" << GRID_SIZE << "\" height=\"" << GRID_SIZE << "\"/></g>\n";
      }
      out << "<text x=\"" << GRID_LEFT << "\" y=\"" << y + static_cast<int>(GRID_SIZE) + 16 << "\">blue: " << words.plus
          << ", orange: " << words.minus << ", black: " << words.zero << "; " << grid.differences() << " of "
          << grid.ours.size() << " verdicts at the left are wrong</text>\n";
    }
    y += GRID_ROW;
  }
  out << "</svg>\n";
}

}  // namespace bounding_arcs_tool
