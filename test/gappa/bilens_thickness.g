# The thickness of a bilens where r_a r_b is at most 1/4, as of short pieces it is, by way of others: THICKNESS_C is that of
# the computed parts and root, THICKNESS_S that of the computed sine of delta and the true other numbers.
{ PROVEN(bilens_roundings) /\ PROVEN(bilens_errors) /\ PROVEN(bilens_sensitivity)
  /\ THICKNESS_C <> 0 /\ THICKNESS_S <> 0 /\ BILENS_THICKNESS <> 0
  -> |bilens_thickness -/ BILENS_THICKNESS| <= 80.2u }

(bilens_thickness - BILENS_THICKNESS) / BILENS_THICKNESS ->
  (1 + (bilens_thickness - THICKNESS_C) / THICKNESS_C) * (1 + (THICKNESS_C - THICKNESS_S) / THICKNESS_S)
  * (1 + (THICKNESS_S - BILENS_THICKNESS) / BILENS_THICKNESS) - 1
  { THICKNESS_C <> 0, THICKNESS_S <> 0, BILENS_THICKNESS <> 0 };
