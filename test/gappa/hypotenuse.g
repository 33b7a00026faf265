# The square of d over the cosine of half the angle, d^2 + cross^2. The larger the angle the more d errs, and the less it
# counts.
ED = (d% - D%) / D%; EA = (d% * bulge% - CROSS%) / CROSS%;
ROUNDED = (bulge% - cross% / d%) / (cross% / d%); GIVEN = (cross% - CROSS%) / CROSS%;
SQUARE = BULGE% * BULGE%;

{ PROVEN(length) /\ PROVEN(bulge) /\ INPUTS
  /\ BULGE% in [0,1]
  /\ NC% / D% = (1 + SQUARE) / 2   # 1 / (1 + cos) by the tangent of the half
  /\ NC% <> 0 /\ D% <> 0 /\ CROSS% <> 0 /\ C <> 0 /\ N% <> 0
  -> |d% * d% * (1 + bulge% * bulge%) -/ D% * D% * (1 + BULGE% * BULGE%)| <= 14.8u }

(nc% + ahead% - D%) / D% -> ((nc% - NC%) / NC% + (ahead% - AHEAD%) / NC%) * (NC% / D%) { NC% <> 0, D% <> 0 };
(d% * d% * (1 + bulge% * bulge%) - D% * D% * (1 + SQUARE)) / (D% * D% * (1 + SQUARE)) ->
  (ED * (2 + ED) + SQUARE * EA * (2 + EA)) / (1 + SQUARE) { D% <> 0, CROSS% <> 0, 1 + SQUARE <> 0 };
EA -> ROUNDED + GIVEN + ROUNDED * GIVEN { CROSS% <> 0, cross% <> 0, d% <> 0 };
$ BULGE% in 32;
