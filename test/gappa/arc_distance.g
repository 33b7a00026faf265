# The distance from an arc where the foot is on it, in parts of R, the distance of the arc's farther end.
QUOTIENT = 2 * side / below; OFF = (below - BELOW) / BELOW; BR = BELOW * R;

{ PROVEN(arc_side) /\ PROVEN(arc_below) /\ DISTANCE / R in [-1,1]
  /\ below <> 0 /\ BELOW <> 0 /\ R <> 0 /\ BR <> 0
  -> |(distance - DISTANCE) / R| <= 37.1u }

(distance - DISTANCE) / R -> (distance - QUOTIENT) / R + (QUOTIENT - DISTANCE) / R { R <> 0 };
QUOTIENT / R -> DISTANCE / R + (QUOTIENT - DISTANCE) / R { R <> 0 };
(QUOTIENT - DISTANCE) / R -> (2 * ((side - SIDE) / BR) - (DISTANCE / R) * OFF) / (1 + OFF)
  { R <> 0, BELOW <> 0, below <> 0 };
