// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the library asks of a compiler: each operation on doubles is rounded by itself, as IEEE 754 has it. Error bounds
// count these roundings, and cross products are antisymmetric by them. Every header of the library includes this one.
//
//   refused       -ffast-math, -Ofast, /fp:fast, and the parts of it that compilers tell of: finite numbers only,
//                 reordered sums, reciprocals; by GCC also zeros without a sign and constants of single precision
//   switched off  by a pragma, from here to the end of the source: contraction into fused multiply-adds, by Clang and
//                 MSVC
//   refused       GCC that optimises for a machine with fused multiply-adds (-mfma, -march=native, arm64): GCC has no
//                 such pragma, contracts by default and does not tell of -ffp-contract=off. Who compiles with that
//                 option says so by -DBOUNDING_ARCS_NO_CONTRACTION; the targets of CMake and pkg-config do
//   not seen      -ffp-contract=fast behind these, which Clang prefers to the pragma; -fno-signed-zeros and
//                 -funsafe-math-optimizations by compilers that do not tell of them; registers of 80 bits

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_STRICT_MATH_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_STRICT_MATH_H

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error "Bounding Arcs: the error bounds do not hold with -ffast-math, -Ofast or /fp:fast. Compile without it."
#endif
#if defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#error "Bounding Arcs: the error bounds do not hold with -fassociative-math or -freciprocal-math. Compile without it."
#endif
#ifdef __FINITE_MATH_ONLY__
#if __FINITE_MATH_ONLY__
#error "Bounding Arcs: numbers that are not finite are tested for. Compile without -ffinite-math-only."
#endif
#endif
#if defined(__GCC_IEC_559) && !defined(__clang__)
#if __GCC_IEC_559 == 0
#error "Bounding Arcs: the error bounds do not hold with -fno-signed-zeros or -fsingle-precision-constant."
#endif
#endif

#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#elif defined(__GNUC__) && defined(__OPTIMIZE__) && defined(__FP_FAST_FMA) && !defined(BOUNDING_ARCS_NO_CONTRACTION)
#error "Bounding Arcs: GCC may contract to fused multiply-adds. Use -ffp-contract=off -DBOUNDING_ARCS_NO_CONTRACTION."
#endif

// The unit of rounding errors, and factors that make up for a few of them.

namespace CGAL::Bounding_arcs {

/// u, half an ulp of 1: an operation rounded to nearest is exact but for a factor of 1 + d, |d| <= u, above underflow.
inline constexpr double HALF_ULP = 0x1p-53;

/// A positive number that has been rounded K - 2 times at most is no less than the exact one after it is multiplied by
/// ROUNDED_UP<K>, and no greater after ROUNDED_DOWN<K>. The product is rounded, too:
///   (1 - u)^(K-1) (1 + K u) >= (1 - (K-1) u) (1 + K u) = 1 + u - K (K-1) u^2 >= 1,
///   (1 + u)^(K-1) (1 - K u) <= (1 + (K-1) u + K^2 u^2) (1 - K u) <= 1 - u + K^2 u^2 <= 1.
template <int K> inline constexpr double ROUNDED_UP = 1 + K* HALF_ULP;
template <int K> inline constexpr double ROUNDED_DOWN = 1 - K* HALF_ULP;

}  // namespace CGAL::Bounding_arcs

/// Functions of some operations in loops that compilers are to vectorise. Stands for `inline`, behind `[[nodiscard]]`.
#if defined(_MSC_VER) && !defined(__clang__)
#define CGAL_BOUNDING_ARCS_INLINE __forceinline
#else
#define CGAL_BOUNDING_ARCS_INLINE [[gnu::always_inline]] inline
#endif

#endif
