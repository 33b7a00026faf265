// Copyright (c) 2026 The Bounding Arcs authors.
// This file is part of Bounding Arcs, an add-on to CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a spiral segment keeps of its curve about the middle of its parameters, for the loops of the library.

#ifndef CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_STORED_LOCAL_CURVE_H
#define CGAL_BOUNDING_ARCS_2_SPIRAL_INTERNAL_STORED_LOCAL_CURVE_H

#include <boost/smart_ptr/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>

#include <cstdint>

namespace CGAL::Bounding_arcs {

struct Local_curve;  // src/library/spiral/Local_curve.h

/// A local curve as segments keep it: without what follows from the segment's ends and the rest. The numbers of cubics,
/// and as many of others, are kept in place, more of them beside.
class Stored_local_curve {
 public:
  /// What numbers do not tell, apart from them, as segments have room for it elsewhere.
  struct Key {
    enum Flags : std::uint8_t { REVERSED = 1, MIRRORED = 2, FITS_FLOAT = 4 };
    std::uint8_t kind = 0, flags = 0;
  };

  Stored_local_curve() = default;
  explicit Stored_local_curve(const Local_curve& curve);
  [[nodiscard]] static Key key(const Local_curve& curve);

 private:
  static constexpr int OWN = 12, MOST = 18;
  struct Beside : boost::intrusive_ref_counter<Beside> {
    double numbers[MOST] = {};
  };
  friend struct Stored_local_curve_access;
  friend struct Segment_curve;

  double numbers_[OWN] = {}, bounds_[6] = {};
  boost::intrusive_ptr<Beside> beside_;  // shared by copies, not changed
};

/// The stored local curve of a segment that outlives it, and what that was stored without.
struct Segment_curve {
  const Stored_local_curve& numbers;
  Stored_local_curve::Key key;
  double first, last, unit;

  /// 0 where there is no local curve.
  [[nodiscard]] int kind() const { return key.kind; }
  operator Local_curve() const;  // NOLINT: it is one
};

/// A local curve for a segment to keep.
struct Kept_local_curve {
  Stored_local_curve numbers;
  Stored_local_curve::Key key;
};

}  // namespace CGAL::Bounding_arcs

#endif
