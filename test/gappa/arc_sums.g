# Both terms of w, each in its coordinate %: u0 + u1, in parts of the distance R of the arc's farther end, and (1 - b^2)
# perp(D), in parts of its length.
{ b in [0,1] /\ FROM% / R in [-1,1] /\ TO% / R in [-1,1] /\ PERP% / LENGTH in [-1,1] /\ R <> 0 /\ LENGTH <> 0
  -> |(sum% - SUM%) / R| <= 4.01u /\ |(lean% - LEAN%) / LENGTH| <= 2.52u }

SUM% / R -> FROM% / R + TO% / R { R <> 0 };
(sum% - SUM%) / R -> (sum% - (from% + to%)) / R + ((from% - FROM%) / R + (to% - TO%) / R) { R <> 0 };
(from% + to%) / R -> SUM% / R + ((from% - FROM%) / R + (to% - TO%) / R) { R <> 0 };
(lean% - LEAN%) / LENGTH ->
  (lean% - m * perp%) / LENGTH + m * ((perp% - PERP%) / LENGTH) + (m - M) * (PERP% / LENGTH) { LENGTH <> 0 };
m * perp% / LENGTH -> m * (PERP% / LENGTH + (perp% - PERP%) / LENGTH) { LENGTH <> 0 };
$ b in 16;
