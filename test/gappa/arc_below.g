# What a distance from an arc is divided by, (1 + b^2) L + |w|; b >= 0. What w is off by has its larger coordinate at %.
A = LONGER / BELOW; RHO = b * R / BELOW; K = (1 + 2 * b - b * b) / (1 + b * b);
NORM = sqrt(w0 * w0 + w1 * w1);   # of the computed w
MOVED = (NORM - APART) / BELOW;

{ b in [0,1] /\ A in [0,1] /\ R in [1b-400,1b400]
  /\ RHO = THETA * (1 - A + K * A) / 4 /\ THETA in [0,1]   # |w| >= 2 b (2 R - L) - (1 - b^2) L
  /\ MOVED = PART * ((w% - W%) / BELOW) /\ PART in [-1.4143,1.4143]   # no length changes more than its vector
  /\ W% / BELOW = COSINE * (1 - A) /\ COSINE in [-1,1]
  /\ FROM% / R in [-1,1] /\ TO% / R in [-1,1] /\ PERP% / LENGTH in [-1,1]
  /\ LENGTH_SQUARE0 / LENGTH_SQUARE in [0,1] /\ LENGTH_SQUARE in [1b-400,1b400]
  /\ w0 * w0 / (w0 * w0 + w1 * w1) in [0,1] /\ w0 * w0 + w1 * w1 in [1b-400,1b400]
  /\ LENGTH <> 0 /\ BELOW <> 0 /\ LONGER <> 0 /\ R <> 0
  -> |(below - BELOW) / BELOW| <= 16.6u }

(below - BELOW) / BELOW -> ((longer + apart) - BELOW) / BELOW + (below - (longer + apart)) / BELOW { BELOW <> 0 };
(longer + apart) / BELOW -> 1 + ((longer + apart) - BELOW) / BELOW { BELOW <> 0 };
((longer + apart) - BELOW) / BELOW -> (longer - LONGER) / LONGER * A + (apart - APART) / BELOW
  { BELOW <> 0, LONGER <> 0 };
(apart - APART) / BELOW -> (apart - NORM) / BELOW + MOVED { BELOW <> 0 };
NORM / BELOW -> (1 - A) + MOVED { BELOW <> 0 };
LENGTH / BELOW -> A / (1 + b * b) { BELOW <> 0, 1 + b * b <> 0 };
(w% - W%) / BELOW -> (w% - (turn% - lean%)) / BELOW + (turn% - TURN%) / BELOW - (lean% - LEAN%) / LENGTH * (LENGTH / BELOW)
  { BELOW <> 0, LENGTH <> 0 };
(turn% - lean%) / BELOW -> W% / BELOW + ((turn% - TURN%) / BELOW - (lean% - LEAN%) / LENGTH * (LENGTH / BELOW))
  { BELOW <> 0, LENGTH <> 0 };
(turn% - TURN%) / BELOW -> (turn% - 2 * b * sum%) / BELOW + 2 * ((sum% - SUM%) / R) * RHO { BELOW <> 0, R <> 0 };
2 * b * sum% / BELOW -> 2 * (SUM% / R + (sum% - SUM%) / R) * RHO { BELOW <> 0, R <> 0 };
SUM% / R -> FROM% / R + TO% / R { R <> 0 };
(sum% - SUM%) / R -> (sum% - (from% + to%)) / R + ((from% - FROM%) / R + (to% - TO%) / R) { R <> 0 };
(from% + to%) / R -> SUM% / R + ((from% - FROM%) / R + (to% - TO%) / R) { R <> 0 };
(lean% - LEAN%) / LENGTH ->
  (lean% - m * perp%) / LENGTH + m * ((perp% - PERP%) / LENGTH) + (m - M) * (PERP% / LENGTH) { LENGTH <> 0 };
m * perp% / LENGTH -> m * (PERP% / LENGTH + (perp% - PERP%) / LENGTH) { LENGTH <> 0 };
$ A in (0.5,0.8,0.95), b in 16;
