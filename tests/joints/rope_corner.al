# A box that hangs by a corner hops on its rope ever lower, until it swings on it; its spin rounds the rates of the hops.
# zero: b.mass-1
simulator -finish 2.1
shape_set box -desc {-sub {-box {0.4 0.2 0.2}}}
body b box -mass 1 -init_pos {0 -0.5 0}
force -body b -gravitational {0 -9.81 0}
rope r -points {{0 0 0} {b {0.2 0.1 0.1}}} -length 1.2 -restitution 0.4
