// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes, once for all programs.

#include <CGAL/Bounding_arcs_2/medial_axis/internal/clearance_path_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/framed_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/maximal_disc_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/medial_axis_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/outline_axis_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/pruned_impl.h>
#include <CGAL/Bounding_arcs_2/medial_axis/internal/trimmed_impl.h>
