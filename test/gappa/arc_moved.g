# How much the length of w changes as its vector does, in parts of what a distance is divided by; b >= 0. What w is off by
# has its larger coordinate at %.
A = LONGER / BELOW; RHO = b * R / BELOW; K = 2 * b * (1 - b) / (1 + b * b);
MOVED = (sqrt(w0 * w0 + w1 * w1) - APART) / BELOW;

{ PROVEN(arc_sums) /\ b in [0,1] /\ A in [0,1] /\ R in [1b-400,1b400]
  /\ RHO = THETA * (1 + K * A) / 4 /\ THETA in [0,1]   # |w| >= 2 b (2 R - L) - (1 - b^2) L
  /\ MOVED = PART * ((w% - W%) / BELOW) /\ PART in [-1.4143,1.4143]   # no length changes more than its vector
  /\ W% / BELOW = COSINE * (1 - A) /\ COSINE in [-1,1] /\ SUM% / R in [-2,2]
  /\ LENGTH <> 0 /\ BELOW <> 0 /\ LONGER <> 0 /\ R <> 0
  -> |(sqrt(w0 * w0 + w1 * w1) - APART) / BELOW| <= 10.2u }

LENGTH / BELOW -> A / (1 + b * b) { BELOW <> 0, 1 + b * b <> 0 };
(w% - W%) / BELOW -> (w% - (turn% - lean%)) / BELOW + (turn% - TURN%) / BELOW - (lean% - LEAN%) / LENGTH * (LENGTH / BELOW)
  { BELOW <> 0, LENGTH <> 0 };
(turn% - lean%) / BELOW -> W% / BELOW + ((turn% - TURN%) / BELOW - (lean% - LEAN%) / LENGTH * (LENGTH / BELOW))
  { BELOW <> 0, LENGTH <> 0 };
(turn% - TURN%) / BELOW -> (turn% - 2 * b * sum%) / BELOW + 2 * ((sum% - SUM%) / R) * RHO { BELOW <> 0, R <> 0 };
2 * b * sum% / BELOW -> 2 * (SUM% / R + (sum% - SUM%) / R) * RHO { BELOW <> 0, R <> 0 };
$ A in (0.7), b in 10;
