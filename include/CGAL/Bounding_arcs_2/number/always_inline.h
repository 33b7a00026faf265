// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An attribute that compilers spell each in its own way.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_ALWAYS_INLINE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_ALWAYS_INLINE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

/// Functions of some operations in loops that compilers are to vectorise. Stands for `inline`, behind `[[nodiscard]]`.
#if defined(_MSC_VER) && !defined(__clang__)
#define CGAL_BOUNDING_ARCS_INLINE __forceinline
#else
#define CGAL_BOUNDING_ARCS_INLINE [[gnu::always_inline]] inline
#endif

#endif
