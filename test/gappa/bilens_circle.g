# A bilens: the parameters r_a, r_b, the contact circles' K at both ends, and center and curvature of the one at the tight
# end. The flat end's has the condition number r_a r_b / (1 - r_a r_b), taken up to 1/3: that of short pieces.
{ PROVEN(length) /\ PROVEN(half_angles) /\ PROVEN(sin_delta) /\ PROVEN(tight_bends) /\ INPUTS
  /\ SIN_TIGHT / CONTACT_TIGHT in [0,1] /\ K_FLAT / CONTACT_FLAT in [0,1]   # terms of one sign
  /\ RATIOS in [0,0.25]
  /\ A <> 0 /\ B <> 0 /\ RATIO_A <> 0 /\ RATIO_B <> 0 /\ CONTACT_TIGHT <> 0 /\ CONTACT_FLAT <> 0 /\ N0 <> 0 /\ UNIT <> 0
  /\ C <> 0 /\ WIDTH <> 0
  -> |ratio_a -/ RATIO_A| <= 54.5u /\ |ratio_b -/ RATIO_B| <= 54.5u /\ |contact_tight -/ CONTACT_TIGHT| <= 95.7u
  /\ |contact_flat -/ CONTACT_FLAT| <= 53.9u
  /\ |lens_curvature -/ LENS_CURVATURE| <= 101.8u
  /\ |lens_center_x -/ LENS_CENTER_X| <= 107.8u /\ |lens_center_y -/ LENS_CENTER_Y| <= 107.8u }
