# The thickness of a bilens where r_a r_b is at most 1/4, as of short pieces it is. The computed sine of delta comes
# first as if it were exact, in THICKNESS_S; what its error changes is bilens_sensitivity.g's.
RATIO_A_S = sin_delta / A; RATIO_B_S = sin_delta / B; RATIOS_S = RATIO_A_S * RATIO_B_S;
TIGHT_S = SIN_TIGHT + sin_delta * RATIO_B_S; FLAT_S = K_FLAT + B * (1 - RATIOS_S);
SLOPE_S = COSINES + RATIO_A_S; CHANGE_S = SLOPE_S + RATIO_B_S; ROOM_S = 4 * (1 - RATIOS_S);
SQUARE_S = CHANGE_S * CHANGE_S; RADICAND_S = SQUARE_S + TIGHT_S * FLAT_S * ROOM_S;
ROOT_S = sqrt(RADICAND_S); DIVISOR_S = CHANGE_S + ROOT_S; THICKNESS_S = WIDTH / 2 * sin_delta * ROOM_S / DIVISOR_S;

{ PROVEN(length) /\ PROVEN(bulge) /\ PROVEN(half_angles) /\ PROVEN(tight_bends) /\ PROVEN(bilens_sensitivity) /\ INPUTS
  /\ RATIOS_S in [0,0.2501] /\ BULGE0 in [0,1] /\ BULGE1 in [0,0.415] /\ BULGE0 * BULGE1 in [0,0.18]
  /\ COSINES / SLOPE_S in [0,1] /\ SLOPE_S / CHANGE_S in [0,1]   # terms of one sign
  /\ SQUARE_S / RADICAND_S in [0,1] /\ CHANGE_S / DIVISOR_S in [0,1]
  /\ SIN_TIGHT / TIGHT_S in [0,1] /\ K_FLAT / FLAT_S in [0,1]
  /\ RADICAND_S in [1b-400,1b400] /\ SLOPE_S <> 0 /\ CHANGE_S <> 0 /\ DIVISOR_S <> 0 /\ C <> 0 /\ UNIT <> 0
  /\ sin_delta <> 0 /\ A <> 0 /\ B <> 0 /\ TIGHT_S <> 0 /\ FLAT_S <> 0
  /\ THICKNESS_S <> 0 /\ BILENS_THICKNESS <> 0
  -> |bilens_thickness -/ BILENS_THICKNESS| <= 90.8u }

radicand ~ RADICAND_S; sqrt(radicand) ~ ROOT_S; bilens_thickness ~ THICKNESS_S;
