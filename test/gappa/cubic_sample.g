# A coordinate of a cubic and its derivatives, in parts of the largest coordinate M of its control points. Powers of two
# bring M between 1 and 2.
{ M in [1,2] /\ t in [0,1]
  /\ p0_x / M in [-1,1] /\ p1_x / M in [-1,1] /\ p2_x / M in [-1,1] /\ p3_x / M in [-1,1]
  /\ B0 / M in [-1,1] /\ B1 / M in [-1,1] /\ B2 / M in [-1,1]   # these and the following are between control points
  /\ C1 / M in [-1,1] /\ C2 / M in [-1,1] /\ POINT / M in [-1,1]
  -> |(point - POINT) / M| <= 8.6u /\ |(first - FIRST) / M| <= 43.3u /\ |(second - SECOND) / M| <= 128.6u }
$ M in 8, t in 16;
