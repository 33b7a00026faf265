# What errors of its parts do to the thickness of a bilens where r_a r_b is at most 1/4: R is that of 1 - r_a r_b, W of the
# change S, K of the contact circle's K at the tight end, F of that at the flat end beside its errors by R, of which it
# has the share X. The divisor D has D^2 = 2 S D + P with the product P under the root; M = 2 S / D. What ends with _S has
# the computed sine of delta and the true other numbers, what ends with _T the computed parts. The root in the divisor errs
# by RHO by itself, which is in D_C.
W = (lens_change - CHANGE_S) / CHANGE_S; K = (contact_tight - TIGHT_S) / TIGHT_S; F = (contact_flat - FLAT_R) / FLAT_R;
E = (width - WIDTH) / WIDTH; R = (part - PART_S) / PART_S; ETA = (D_T - D_S) / D_S; DIFFERENCE = R - ETA;
RHO = (root - ROOT_T) / ROOT_T; SHARE = 1 - M * (1 + W) / (1 + ETA) / 2; D_C = D_T * (1 + SHARE * RHO);
THICKNESS_S = WIDTH * sin_delta * PART_S / D_S; THICKNESS_C = width * sin_delta * part / D_C;
SECOND = K * (F + X * R + F * X * R) + F * X * R + R * (K + F + X * R + K * F + K * X * R + F * X * R + K * F * X * R);
CHANGED = (R * (1 - X * (1 - M) + ETA - M * W) - M * W - (1 - M) * (K + F + SECOND)) / (2 - M + ETA - M * W);

{ PROVEN(bilens_parts) /\ |ETA| <= 1b-40 /\ CHANGE_S <> 0 /\ TIGHT_S <> 0 /\ FLAT_R <> 0
  /\ ROOT_T <> 0 /\ M in [0,1] /\ X in [0,1]
  /\ DIFFERENCE = CHANGED   # from both quadratic equations: S_T = S (1 + W), P_T = P (1 + K) (1 + F) (1 + X R) (1 + R)
  /\ sin_delta <> 0 /\ WIDTH <> 0 /\ PART_S <> 0 /\ D_S <> 0 /\ D_T <> 0 /\ D_C <> 0 /\ THICKNESS_S <> 0
  -> |THICKNESS_C -/ THICKNESS_S| <= 35.9u }

(THICKNESS_C - THICKNESS_S) / THICKNESS_S -> (E + (1 + E) * DIFFERENCE / (1 + ETA) - SHARE * RHO) / (1 + SHARE * RHO)
  { sin_delta <> 0, WIDTH <> 0, PART_S <> 0, D_S <> 0, D_T <> 0, D_C <> 0, THICKNESS_S <> 0 };
$ M in 400;
