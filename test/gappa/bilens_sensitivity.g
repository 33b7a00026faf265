# What the error E of the sine of delta does to the thickness of a bilens where r_a r_b is at most 1/4. The sine is in
# each of its parts, where E cancels in part: in r_a r_b, in the change S by its part W, in the contact circles' K by V
# and X. The divisor D has D^2 = 2 S D + P with the product P under the root; M = 2 S / D. What ends with _S has the
# computed sine.
RATIOS = SIN_DELTA * SIN_DELTA / (A * B); RATIOS_S = sin_delta * sin_delta / (A * B);
BILENS_THICKNESS = WIDTH * SIN_DELTA * (1 - RATIOS) / D; THICKNESS_S = WIDTH * sin_delta * (1 - RATIOS_S) / D_S;
E = (sin_delta - SIN_DELTA) / SIN_DELTA; G = 2 + E; ETA = (D_S - D) / D; H = ETA / E; Q = RATIOS / (1 - RATIOS);
PHI = G * (V - Q * (1 + X)) + E * (G * G) * (Q * X * Q - Q * X * V - V * Q) + E * E * (G * G * G) * (Q * X * V * Q);
CHANGED = (M * W + (1 - M) * PHI) / (2 - M + ETA - M * W * E);

{ PROVEN(sin_delta) /\ |ETA| <= 1b-40 /\ Q in [0,0.33334]   # r_a r_b / (1 - r_a r_b)
  /\ M in [0,1] /\ W in [0,1] /\ V in [0,1] /\ X in [0,1]
  /\ H = CHANGED   # from both quadratic equations: P_S = P (1 + PHI E), S_S = S (1 + W E)
  /\ SIN_DELTA <> 0 /\ A <> 0 /\ B <> 0 /\ D <> 0 /\ D_S <> 0 /\ WIDTH <> 0 /\ BILENS_THICKNESS <> 0
  /\ E <> 0   # else THICKNESS_S is the thickness
  -> |THICKNESS_S -/ BILENS_THICKNESS| <= 40.2u }

(THICKNESS_S - BILENS_THICKNESS) / BILENS_THICKNESS -> E * (1 - G * Q - E * G * Q - H) / (1 + ETA)
  { SIN_DELTA <> 0, A <> 0, B <> 0, BILENS_THICKNESS <> 0, D <> 0, D_S <> 0, WIDTH <> 0, E <> 0 };
$ Q in 48, M in 48;
