# The thickness of a bilens where r_a r_b is at most 1/4, as of short pieces it is.
{ PROVEN(length) /\ PROVEN(bulge) /\ PROVEN(sin_delta) /\ PROVEN(tight_bends) /\ PROVEN(bilens_circle) /\ INPUTS
  /\ RATIOS in [0,0.25] /\ BULGE0 in [0,1] /\ BULGE1 in [0,0.415] /\ BULGE0 * BULGE1 in [0,0.18]
  /\ COSINES / SLOPE in [0,1] /\ SLOPE / LENS_CHANGE in [0,1]   # terms of one sign
  /\ LENS_SQUARE / RADICAND in [0,1] /\ LENS_CHANGE / DIVISOR in [0,1]
  /\ RADICAND in [1b-400,1b400] /\ SLOPE <> 0 /\ LENS_CHANGE <> 0 /\ DIVISOR <> 0 /\ C <> 0 /\ UNIT <> 0
  /\ SIN_DELTA <> 0 /\ A <> 0 /\ B <> 0 /\ CONTACT_TIGHT <> 0 /\ CONTACT_FLAT <> 0
  -> |bilens_thickness -/ BILENS_THICKNESS| <= 182.2u }
