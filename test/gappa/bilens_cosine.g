# The cosine of the mean of two angles that are at most a right one together, from their bulges b0, b1 with errors E0, E1:
# cos = (1 - b0 b1) / sqrt((1 + b0^2) (1 + b1^2)). What ends with _C has the computed bulges. T is the tangent, SINES half
# the sum of both sines, of which the first has the share Y.
ABOVE = 1 - BULGE0 * BULGE1; ABOVE_C = 1 - bulge0 * bulge1; COS_MEAN = ABOVE / ROOTS; COS_MEAN_C = ABOVE_C / ROOTS_C;
H = (ROOTS_C - ROOTS) / ROOTS; DIFFERENCE = (ABOVE_C - ABOVE) / ABOVE - H;
E0 = (bulge0 - BULGE0) / BULGE0; E1 = (bulge1 - BULGE1) / BULGE1;
CHANGED0 = U0 * E0 * (2 + E0); CHANGED1 = U1 * E1 * (2 + E1);
REST = (U0 * E0 * E0 + U1 * E1 * E1 + CHANGED0 * CHANGED1 - H * H) / 2 + Q * E0 * E1;
CHANGED = -(T * SINES * (Y * E0 + (1 - Y) * E1) + REST);

{ PROVEN(bulge) /\ |H| <= 1b-40 /\ BULGE0 <> 0 /\ BULGE1 <> 0
  /\ T in [0,1] /\ SINES in [0,0.70711] /\ Y in [0,1] /\ U0 in [0,0.5] /\ U1 in [0,0.5] /\ Q in [0,0.25]
  /\ DIFFERENCE = CHANGED   # U = b^2 / (1 + b^2), Q = b0 b1 / (1 - b0 b1); Q + U0 = T SINES Y, Q + U1 = T SINES (1 - Y)
  /\ COS_MEAN <> 0 /\ ABOVE <> 0 /\ ROOTS <> 0 /\ ROOTS_C <> 0
  -> |COS_MEAN_C -/ COS_MEAN| <= 10.4u }

(COS_MEAN_C - COS_MEAN) / COS_MEAN -> DIFFERENCE / (1 + H) { COS_MEAN <> 0, ABOVE <> 0, ROOTS <> 0, ROOTS_C <> 0 };
$ Y in 64;
