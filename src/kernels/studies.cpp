// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stability study, once for all programs.

#include <CGAL/Bounding_arcs_2/study/internal/Stability_study_impl.h>
