# Curvatures times half the chord, and Kneser's differences of these from the sines.
{ PROVEN(length) /\ INPUTS 
  /\ SQUARE_X0 / SQUARE0 in [0,1] /\ SQUARE0 <> 0 /\ SQUARE_X1 / SQUARE1 in [0,1] /\ SQUARE1 <> 0
  /\ SQUARE_X_C / SQUARE_C in [0,1] /\ SQUARE_C <> 0
  /\ N0 <> 0 /\ N1 <> 0 /\ C <> 0
  -> |k_tight -/ K_TIGHT| <= 14.2u /\ |k_flat -/ K_FLAT| <= 14.2u /\ |a -/ A| <= 14.2u /\ |b -/ B| <= 14.2u
  /\ |sin_difference -/ SIN_DIFFERENCE| <= 14.2u}
