# The lengths n0, n1, c: roots of sums of two squares. Each square is a part of its sum.
{ INPUTS
  /\ SQUARE_X0 / SQUARE0 in [0,1] /\ SQUARE0 in [1b-400,1b400]
  /\ SQUARE_X1 / SQUARE1 in [0,1] /\ SQUARE1 in [1b-400,1b400]
  /\ SQUARE_X_C / SQUARE_C in [0,1] /\ SQUARE_C in [1b-400,1b400]
  -> |n0 -/ N0| <= 3.04u /\ |n1 -/ N1| <= 3.04u /\ |c -/ C| <= 3.04u }
