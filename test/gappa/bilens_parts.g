# The parts of a bilens' thickness where r_a r_b is at most 1/4, beside those of the computed sine of delta and the true
# other numbers: the change S, the contact circles' K at both ends, 1 - r_a r_b. That is in the flat end's K, which comes
# beside the one with the computed 1 - r_a r_b: their errors cancel in part, see bilens_errors.g.
RATIO_A_S = sin_delta / A; RATIO_B_S = sin_delta / B; RATIOS_S = RATIO_A_S * RATIO_B_S; PART_S = 1 - RATIOS_S;
SQUARE_T = lens_change * lens_change; RADICAND_T = SQUARE_T + contact_tight * contact_flat * (4 * part);
ROOT_T = sqrt(RADICAND_T);
TIGHT_S = SIN_TIGHT + sin_delta * RATIO_B_S; FLAT_R = K_FLAT + B * part;
COS_MEAN_C = (1 - bulge0 * bulge1) * (1 / sqrt((1 + bulge0 * bulge0) * (1 + bulge1 * bulge1)));
SLOPE_S = COSINES + RATIO_A_S; CHANGE_S = SLOPE_S + RATIO_B_S;

{ PROVEN(bilens_cosine) /\ PROVEN(length) /\ PROVEN(bulge) /\ PROVEN(half_angles) /\ PROVEN(tight_bends) /\ INPUTS
  /\ RATIOS_S in [0,0.2501] /\ BULGE0 in [0,1] /\ BULGE1 in [0,0.415] /\ BULGE0 * BULGE1 in [0,0.18]
  /\ COSINES / SLOPE_S in [0,1] /\ SLOPE_S / CHANGE_S in [0,1]   # terms of one sign
  /\ SIN_TIGHT / TIGHT_S in [0,1] /\ K_FLAT / FLAT_R in [0,1]
  /\ SQUARE_T / RADICAND_T in [0,1] /\ RADICAND_T in [1b-400,1b400]
  /\ SLOPE_S <> 0 /\ CHANGE_S <> 0 /\ C <> 0 /\ sin_delta <> 0 /\ A <> 0 /\ B <> 0 /\ TIGHT_S <> 0 /\ FLAT_R <> 0
  /\ PART_S <> 0 /\ COS_MEAN <> 0 /\ COS_MEAN_C <> 0
  -> |lens_change -/ CHANGE_S| <= 17.8u /\ |contact_tight -/ TIGHT_S| <= 17.3u /\ |contact_flat -/ FLAT_R| <= 16.3u
  /\ |part -/ PART_S| <= 11.2u /\ |width -/ WIDTH| <= 5.1u /\ |root -/ ROOT_T| <= 2.6u }

radicand ~ RADICAND_T; sqrt(radicand) ~ ROOT_T;
(cos_mean - COS_MEAN) / COS_MEAN -> (1 + (cos_mean - COS_MEAN_C) / COS_MEAN_C) * (1 + (COS_MEAN_C - COS_MEAN) / COS_MEAN) - 1
  { COS_MEAN <> 0, COS_MEAN_C <> 0 };
