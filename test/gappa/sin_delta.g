# The sine of half the difference of the angles: the change over both hypotenuses.
G0 = D0 * D0 * (1 + BULGE0 * BULGE0); G1 = D1 * D1 * (1 + BULGE1 * BULGE1);
G0_D = d0 * d0 * (1 + bulge0 * bulge0); G1_D = d1 * d1 * (1 + bulge1 * bulge1);
SIN_D = CHANGE / (d0 * d1) * (1 / sqrt((1 + bulge0 * bulge0) * (1 + bulge1 * bulge1)));

{ PROVEN(change) /\ PROVEN(hypotenuse) /\ PROVEN(length) /\ INPUTS
  /\ BULGE0 in [0,1] /\ BULGE1 in [0,1] /\ bulge0 in [0,2] /\ bulge1 in [0,2]
  /\ SIN_D = CHANGE / sqrt(G0_D * G1_D) /\ SIN_DELTA = CHANGE / sqrt(G0 * G1)   # a positive number and the root of its square
  /\ G0 in [1b-400,1b400] /\ G1 in [1b-400,1b400] /\ G0_D in [1b-400,1b400] /\ G1_D in [1b-400,1b400]
  /\ CHANGE <> 0 /\ SIN_DELTA <> 0 /\ SIN_D <> 0
  -> |sin_delta -/ SIN_DELTA| <= 39.2u }
