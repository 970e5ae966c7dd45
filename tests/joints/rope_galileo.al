# Galileo's pendulum: its string meets a peg, winds up on it, and lifts off again (own integration).
# zero: b.z
simulator -finish 3.5 -collisions 0
shape_set ball -desc {-sub {-sphere 0.05}}
body peg ball -fixed 1 -init_pos {0.01 -0.5 0}
body b ball -mass 1 -init_pos {-0.6 -0.8 0}
rope r -points {{0 0 0} {peg {0 0 0} -0.01} {b {0 0 0}}} -length 1
force -body b -gravitational {0 -9.81 0}
