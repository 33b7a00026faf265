# What a distance from an arc is divided by, (1 + b^2) L + |w|; b >= 0.
A = LONGER / BELOW;
NORM = sqrt(w0 * w0 + w1 * w1);   # of the computed w

{ PROVEN(arc_moved) /\ b in [0,1] /\ A in [0,1]
  /\ LENGTH_SQUARE0 / LENGTH_SQUARE in [0,1] /\ LENGTH_SQUARE in [1b-400,1b400]
  /\ w0 * w0 / (w0 * w0 + w1 * w1) in [0,1] /\ w0 * w0 + w1 * w1 in [1b-400,1b400]
  /\ LENGTH <> 0 /\ BELOW <> 0 /\ LONGER <> 0
  -> |(below - BELOW) / BELOW| <= 17u }

(below - BELOW) / BELOW -> ((longer + apart) - BELOW) / BELOW + (below - (longer + apart)) / BELOW { BELOW <> 0 };
(longer + apart) / BELOW -> 1 + ((longer + apart) - BELOW) / BELOW { BELOW <> 0 };
((longer + apart) - BELOW) / BELOW -> (longer - LONGER) / LONGER * A + (apart - APART) / BELOW
  { BELOW <> 0, LONGER <> 0 };
(apart - APART) / BELOW -> (apart - NORM) / BELOW + (NORM - APART) / BELOW { BELOW <> 0 };
NORM / BELOW -> (1 - A) + (NORM - APART) / BELOW { BELOW <> 0 };
$ A in 4, b in 4;
