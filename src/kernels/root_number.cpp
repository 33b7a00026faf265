// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers with square roots, once for all programs.

#include <CGAL/Bounding_arcs_2/number/internal/Root_number_impl.h>

template class CGAL::Bounding_arcs::internal::Basic_root_number<CORE::Expr>;
