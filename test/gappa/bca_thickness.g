# The chord's length c is in numerator and denominator, where its error cancels in part. So the computed c comes first as
# if it were exact, in THICKNESS_C, and then what its error E changes. The end % has the larger angle.
D0_C = N0 * c + AHEAD0; D1_C = N1 * c + AHEAD1;
OF_SQUARES_C = c * SQUARE_CHANGE * (CROSSES / BOTH);
CHANGE_C = OF_SQUARES_C + SINE_CHANGE;
THICKNESS_C = UNIT * (c * CHANGE_C / (2 * D0_C * D1_C));
COS0 = AHEAD0 / NC0; COS1 = AHEAD1 / NC1;
X0 = 1 / (1 + COS0); X1 = 1 / (1 + COS1);
E = (c - C) / C; W = OF_SQUARES / CHANGE;

{ PROVEN(length) /\ PROVEN(bulge) /\ INPUTS
  /\ FIRST / BOTH in [0,1] /\ CROSS0 / CROSSES in [0,1] /\ W in [0,1]   # terms of one sign
  /\ COS0 in [0,1] /\ COS1 in [0,1] /\ COS0 * COS0 + COS1 * COS1 >= 1   # of angles that make a right one at most
  /\ COS& - COS% >= 0
  /\ C <> 0 /\ NC0 <> 0 /\ NC1 <> 0 /\ D0 <> 0 /\ D1 <> 0 /\ BOTH <> 0 /\ CROSSES <> 0 /\ CHANGE <> 0
  /\ UNIT <> 0 /\ D0_C <> 0 /\ D1_C <> 0 /\ CHANGE_C <> 0 /\ THICKNESS <> 0 /\ N0 <> 0 /\ N1 <> 0
  -> |thickness -/ THICKNESS| <= 34.1u }

c / C -> 1 + E { C <> 0 };
OF_SQUARES_C / CHANGE_C -> W * (1 + E) / (1 + W * E) { C <> 0, CHANGE <> 0, CHANGE_C <> 0 };
(nc0 + ahead0 - D0_C) / D0_C ->
  ((nc0 - N0 * c) / (N0 * c) * (c / C) + (ahead0 - AHEAD0) / NC0) / (c / C + COS0)
  { NC0 <> 0, D0_C <> 0, C <> 0, N0 <> 0, c <> 0 };
(nc1 + ahead1 - D1_C) / D1_C ->
  ((nc1 - N1 * c) / (N1 * c) * (c / C) + (ahead1 - AHEAD1) / NC1) / (c / C + COS1)
  { NC1 <> 0, D1_C <> 0, C <> 0, N1 <> 0, c <> 0 };
c * CHANGE_C / (2 * D0_C * D1_C) -> (c / D%_C) * (CHANGE_C / D&_C) / 2 { D%_C <> 0, D&_C <> 0 };
C * CHANGE / (2 * D0 * D1) -> (C / D%) * (CHANGE / D&) / 2 { D% <> 0, D& <> 0 };
(c / D%_C - C / D%) / (C / D%) -> E * (1 - X%) / (1 + X% * E) { C <> 0, NC% <> 0, D% <> 0, D%_C <> 0 };
(CHANGE_C / D&_C - CHANGE / D&) / (CHANGE / D&) -> E * (W - X&) / (1 + X& * E)
  { C <> 0, NC& <> 0, D& <> 0, D&_C <> 0, CHANGE <> 0, CHANGE_C <> 0 };
thickness ~ THICKNESS_C;
THICKNESS_C ~ THICKNESS;
$ COS% in 16, COS& in 16;
