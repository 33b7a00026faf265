{ PROVEN(length) /\ INPUTS
  /\ |AHEAD_X% / NC%| + |AHEAD_Y% / NC%| in [0,1]   # Cauchy and Schwarz
  /\ |AHEAD_X% / NC%| in [0,1] /\ |AHEAD_Y% / NC%| in [0,1]
  /\ AHEAD% / NC% in [0,1]   # the cosine of an angle that is at most right
  /\ NC% <> 0 /\ D% <> 0
  -> |(ahead% - AHEAD%) / NC%| <= 4.1u /\ |d% -/ D%| <= 12.3u /\ |bulge% -/ BULGE%| <= 14.4u }

# The scalar product errs in parts of n c. Its terms may cancel.
(ahead% - AHEAD%) / NC% -> ((ahead_x% + ahead_y%) - AHEAD%) / NC% + (ahead% - (ahead_x% + ahead_y%)) / NC% { NC% <> 0 };
((ahead_x% + ahead_y%) - AHEAD%) / NC% -> (ahead_x% - AHEAD_X%) / NC% + (ahead_y% - AHEAD_Y%) / NC% { NC% <> 0 };
(ahead_x% + ahead_y%) / NC% -> AHEAD% / NC% + ((ahead_x% + ahead_y%) - AHEAD%) / NC% { NC% <> 0 };
(nc% + ahead% - D%) / D% -> ((nc% - NC%) / NC% + (ahead% - AHEAD%) / NC%) / (1 + AHEAD% / NC%) { NC% <> 0, D% <> 0 };
$ |AHEAD_X% / NC%| in 64;
