# The numerator of a distance from an arc where the foot is on it, in parts of what it is divided by and of R, the distance
# of the arc's farther end; b >= 0.
A = LONGER / BELOW; RHO = b * R / BELOW; K = 2 * b * (1 - b) / (1 + b * b);
LR = LENGTH * R; RR = R * R; BR = BELOW * R;

{ PROVEN(arc_products)
  /\ b in [0,1] /\ A in [0,1] /\ R in [1b-400,1b400]
  /\ RHO = THETA * (1 + K * A) / 4 /\ THETA in [0,1]   # |w| >= 2 b (2 R - L) - (1 - b^2) L
  /\ ACROSS / LR in [-1,1] /\ PRODUCT / RR in [-1,1] /\ DISTANCE / R in [-1,1]
  /\ LENGTH <> 0 /\ BELOW <> 0 /\ LONGER <> 0 /\ R <> 0 /\ RR <> 0 /\ LR <> 0 /\ BR <> 0
  -> |(side - SIDE) / (BELOW * R)| <= 9.5u }

(side - SIDE) / BR -> ((side_1 - side_2) - SIDE) / BR + (side - (side_1 - side_2)) / BR { BR <> 0 };
(side_1 - side_2) / BR -> DISTANCE / R / 2 + ((side_1 - side_2) - SIDE) / BR { BR <> 0 };
((side_1 - side_2) - SIDE) / BR -> (side_1 - SIDE_1) / LR * (LENGTH / BELOW) - (side_2 - SIDE_2) / BR
  { LENGTH <> 0, BELOW <> 0, R <> 0 };
LENGTH / BELOW -> A / (1 + b * b) { BELOW <> 0, 1 + b * b <> 0 };
(side_1 - SIDE_1) / LR -> (side_1 - m * across) / LR + m * ((across - ACROSS) / LR) + (m - M) * (ACROSS / LR)
  { LR <> 0 };
m * across / LR -> m * (ACROSS / LR + (across - ACROSS) / LR) { LR <> 0 };
(side_2 - SIDE_2) / BR -> (side_2 - 2 * b * product) / BR + 2 * ((product - PRODUCT) / RR) * RHO
  { BELOW <> 0, R <> 0 };
2 * b * product / BR -> 2 * (PRODUCT / RR + (product - PRODUCT) / RR) * RHO { BELOW <> 0, R <> 0 };
$ A in (0.7,0.9), b in 12;
