#!/usr/bin/env python3
# Copyright (c) 2026 The Bounding Arcs authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The figure of a study of stability: relative errors against delta, a panel for each family and quantity, a line for
# each method and number type. A grey line is what the problem itself leaves of double: its condition number times the
# unit roundoff. Needs matplotlib.
# Usage: python3 plot_study.py ROWS.csv FIGURE.pdf
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

UNIT_ROUNDOFF = 2.0**-53
LEAST = 1e-36  # an error of 0 is drawn here

with open(sys.argv[1], newline="") as file:
    rows = [row for row in csv.DictReader(line for line in file if not line.startswith("#"))]

panels = sorted({(row["family"], row["quantity"]) for row in rows if not row["quantity"].endswith("estimated")})
figure, axes = plt.subplots(1, len(panels), figsize=(6.0 * len(panels), 4.0), squeeze=False)
for panel, (family, quantity) in zip(axes[0], panels):
    lines, problem = {}, {}
    for row in rows:
        if (row["family"], row["quantity"]) != (family, quantity):
            continue
        delta = float(row["delta"])
        name = f'{row["method"]}, {row["kernel"]}'
        lines.setdefault(name, []).append((delta, max(float(row["rel_error"]), LEAST)))
        if row["condition"]:
            problem[delta] = max(problem.get(delta, 0), float(row["condition"]) * UNIT_ROUNDOFF)
    for name, points in lines.items():
        panel.loglog(*zip(*sorted(points)), marker="o", markersize=3, label=name)
    if problem:
        panel.loglog(*zip(*sorted(problem.items())), color="grey", linestyle="--", label="condition × 2⁻⁵³")
    panel.invert_xaxis()
    panel.set_xlabel("δ, smaller to the right")
    panel.set_ylabel("relative error")
    panel.set_title(f"{family}: {quantity}")
    panel.grid(True, which="major", linewidth=0.4)
    panel.legend(fontsize=8)
figure.tight_layout()
figure.savefig(sys.argv[2])
