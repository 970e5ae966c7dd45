# A pendulum whose rope winds up on a peg (own integration).
# zero: b.z
simulator -finish 3 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body peg disc -fixed 1
body b ball -mass 1 -init_pos {-0.1 -1 0} -init_dpos {2.5 0 0}
force -body b -gravitational {0 -9.81 0}
rope r -points {{peg {0 0 0} 0.1} {b {0 0 0}}}
