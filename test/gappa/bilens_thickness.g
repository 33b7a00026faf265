# The thickness of a bilens where r_a r_b is at most 1/4, as of short pieces it is: roundings of the last steps beside
# THICKNESS_C, that of the computed parts and root. What their errors change is bilens_errors.g's, beside THICKNESS_S of
# the computed sine of delta; what the error of that changes is bilens_sensitivity.g's.
THICKNESS_C = width / 2 * sin_delta * (4 * part) / (lens_change + root);

{ PROVEN(bilens_sensitivity) /\ PROVEN(bilens_errors)
  /\ lens_change + root <> 0 /\ THICKNESS_C <> 0 /\ THICKNESS_S <> 0 /\ BILENS_THICKNESS <> 0
  -> |bilens_thickness -/ BILENS_THICKNESS| <= 80.2u }

bilens_thickness ~ THICKNESS_C;
(bilens_thickness - BILENS_THICKNESS) / BILENS_THICKNESS ->
  (1 + (bilens_thickness - THICKNESS_C) / THICKNESS_C) * (1 + (THICKNESS_C - THICKNESS_S) / THICKNESS_S)
  * (1 + (THICKNESS_S - BILENS_THICKNESS) / BILENS_THICKNESS) - 1
  { THICKNESS_C <> 0, THICKNESS_S <> 0, BILENS_THICKNESS <> 0 };
