# The center of a BCA's arc as seen from the end that it touches, and the square of its radius.
{ INPUTS /\ SQUARE_X_C / SQUARE_C in [0,1] /\ SQUARE_C <> 0 /\ CROSS0 <> 0
  /\ CENTER_X * CENTER_X / SQUARED_RADIUS in [0,1] /\ SQUARED_RADIUS <> 0
  -> |center_x -/ CENTER_X| <= 10.1u /\ |center_y -/ CENTER_Y| <= 10.1u /\ |squared_radius -/ SQUARED_RADIUS| <= 22.2u }
