// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Chains of arcs and offsets, once for all programs.

#include <CGAL/Bounding_arcs_2/chain/internal/arc_chain_impl.h>
#include <CGAL/Bounding_arcs_2/offset/internal/Offset_source_impl.h>
#include <CGAL/Bounding_arcs_2/offset/internal/offset_bracket_impl.h>
#include <CGAL/Bounding_arcs_2/offset/internal/offset_error_impl.h>
#include <CGAL/Bounding_arcs_2/offset/internal/offset_series_impl.h>
