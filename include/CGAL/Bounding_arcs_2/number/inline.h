// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bodies that the library has compiled.  What is no template and takes long to compile is declared in its header, and
// its body is in an `_impl.h` file: src/kernels/ reads that once for all programs, a program without the library
// (BOUNDING_ARCS_KERNELS is not defined) behind the declaration.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_INLINE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_INLINE_H

/// Marks a body that is compiled in the library, or is inline without it.
#ifdef BOUNDING_ARCS_KERNELS
#define CGAL_BOUNDING_ARCS_INLINE
#else
#define CGAL_BOUNDING_ARCS_INLINE inline
#endif

#endif
