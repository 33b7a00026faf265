// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Medial axes, once for all programs.

#include <CGAL/Bounding_arcs_2/internal/medial_axis/clearance_path_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/framed_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/maximal_disc_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/medial_axis_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/outline_axis_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/pruned_impl.h>
#include <CGAL/Bounding_arcs_2/internal/medial_axis/trimmed_impl.h>
