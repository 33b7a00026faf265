// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Values that are made when they are first asked for.

#ifndef CGAL_BOUNDING_ARCS_2_NUMBER_MADE_ONCE_H
#define CGAL_BOUNDING_ARCS_2_NUMBER_MADE_ONCE_H

#include <CGAL/Bounding_arcs_2/number/strict_math.h>

#include <atomic>
#include <memory>

namespace CGAL::Bounding_arcs {

namespace internal {
/// A value that is made when it is first asked for, from any thread; until then it takes the room of a pointer.
template <class T> class Made_once {
 public:
  Made_once() = default;
  Made_once(const Made_once&) = delete;
  Made_once& operator=(const Made_once&) = delete;
  ~Made_once() { delete value_.load(std::memory_order_relaxed); }

  /// Returns the value, if it is made. \pre no other thread asks for it
  [[nodiscard]] T* made() { return value_.load(std::memory_order_acquire); }
  /// What the first `make()` returned; threads that come together may each make one, of which one is kept.
  template <class Make> const T& operator()(const Make& make) const {
    if (const T* made = value_.load(std::memory_order_acquire)) return *made;
    auto own = std::make_unique<T>(make());
    T* other = nullptr;
    return value_.compare_exchange_strong(other, own.get(), std::memory_order_acq_rel) ? *own.release() : *other;
  }

 private:
  mutable std::atomic<T*> value_{nullptr};
};
}  // namespace internal

}  // namespace CGAL::Bounding_arcs

#endif
