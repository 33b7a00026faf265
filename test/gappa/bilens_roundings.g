# Roundings of the last steps of a bilens' thickness, beside that of the computed parts and root.
THICKNESS_C = width / 2 * sin_delta * (4 * part) / (lens_change + root);

{ lens_change + root <> 0 /\ THICKNESS_C <> 0 -> |bilens_thickness -/ THICKNESS_C| <= 4.1u }
