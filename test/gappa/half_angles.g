# Sine and cosine of the angle at the tight end from the tangent of its half. The larger the angle, the less d errs.
SQUARE = bulge0 * bulge0; SIN_B = 2 * bulge0 / (1 + SQUARE); COS_B = (1 - SQUARE) / (1 + SQUARE);
E = (bulge0 - BULGE0) / BULGE0;

{ PROVEN(length) /\ PROVEN(bulge) /\ INPUTS
  /\ BULGE0 in [1b-400,1]
  /\ NC0 / D0 = (1 + SQUARE_B) / 2   # 1 / (1 + cos) by the tangent of the half
  /\ C <> 0 /\ N0 <> 0 /\ NC0 <> 0 /\ D0 <> 0 /\ CROSS0 <> 0 /\ SIN_TIGHT <> 0 
  -> |sin_tight -/ SIN_TIGHT| <= 10.8u /\ |cos_tight - COS_TIGHT| <= 16u }

(nc0 + ahead0 - D0) / D0 -> ((nc0 - NC0) / NC0 + (ahead0 - AHEAD0) / NC0) * (NC0 / D0) { NC0 <> 0, D0 <> 0 };
(SIN_B - SIN_TIGHT) / SIN_TIGHT -> E * (1 - SQUARE_B * (1 + E)) / (1 + SQUARE)
  { BULGE0 <> 0, D0 <> 0, 1 + SQUARE <> 0, BELOW <> 0 };
COS_B - COS_TIGHT -> -2 * E * SQUARE_B * (2 + E) / ((1 + SQUARE) * BELOW)
  { BULGE0 <> 0, D0 <> 0, 1 + SQUARE <> 0, BELOW <> 0 };
above / below - COS_B -> (above - (1 - SQUARE)) / below - COS_B * ((below - (1 + SQUARE)) / below)
  { below <> 0, 1 + SQUARE <> 0 };
sin_tight ~ SIN_B;
$ BULGE0 in 32;
