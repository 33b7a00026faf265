# The curvature of an arc from its ends and its bulge.
{ SQUARE_X / SQUARE in [0,1] /\ SQUARE in [1b-400,1b400] /\ SQUARE_B in [0,1] /\ bulge <> 0
  -> |curvature -/ CURVATURE| <= 6.2u }
$ SQUARE_B in 8;
