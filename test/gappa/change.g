# A d1 - B d0, the change of bulges times d0 d1. All sums have terms of one sign.
{ PROVEN(length) /\ INPUTS
  /\ FIRST / BOTH in [0,1] /\ CROSS0 / CROSSES in [0,1] /\ OF_SQUARES / CHANGE in [0,1]
  /\ BOTH <> 0 /\ CROSSES <> 0 /\ CHANGE <> 0
  -> |change -/ CHANGE| <= 17u }
