# Cross and scalar products of a distance's vectors, in parts of the lengths that they are of. R is the distance of the
# arc's farther end, so that neither u0 nor u1 is longer.
{ b in [0,1] /\ |ACROSS_1 / (LENGTH * R)| + |ACROSS_2 / (LENGTH * R)| in [0,1]   # Cauchy and Schwarz
  /\ |ACROSS_1 / (LENGTH * R)| in [0,1] /\ |ACROSS_2 / (LENGTH * R)| in [0,1]
  /\ |PRODUCT_X / (R * R)| + |PRODUCT_Y / (R * R)| in [0,1]
  /\ |PRODUCT_X / (R * R)| in [0,1] /\ |PRODUCT_Y / (R * R)| in [0,1]
  /\ ACROSS / (LENGTH * R) in [-1,1] /\ PRODUCT / (R * R) in [-1,1]
  /\ LENGTH * R <> 0 /\ R * R <> 0 /\ R in [1b-400,1b400]
  -> |(across - ACROSS) / (LENGTH * R)| <= 4.1u /\ |(product - PRODUCT) / (R * R)| <= 4.1u }

(across - ACROSS) / (LENGTH * R) ->
  ((across_1 - across_2) - ACROSS) / (LENGTH * R) + (across - (across_1 - across_2)) / (LENGTH * R) { LENGTH * R <> 0 };
((across_1 - across_2) - ACROSS) / (LENGTH * R) ->
  (across_1 - ACROSS_1) / (LENGTH * R) - (across_2 - ACROSS_2) / (LENGTH * R) { LENGTH * R <> 0 };
(across_1 - across_2) / (LENGTH * R) ->
  ACROSS / (LENGTH * R) + ((across_1 - across_2) - ACROSS) / (LENGTH * R) { LENGTH * R <> 0 };
(product - PRODUCT) / (R * R) ->
  ((product_x + product_y) - PRODUCT) / (R * R) + (product - (product_x + product_y)) / (R * R) { R * R <> 0 };
((product_x + product_y) - PRODUCT) / (R * R) ->
  (product_x - PRODUCT_X) / (R * R) + (product_y - PRODUCT_Y) / (R * R) { R * R <> 0 };
(product_x + product_y) / (R * R) ->
  PRODUCT / (R * R) + ((product_x + product_y) - PRODUCT) / (R * R) { R * R <> 0 };
$ |ACROSS_1 / (LENGTH * R)| in 64;
$ |PRODUCT_X / (R * R)| in 64;
