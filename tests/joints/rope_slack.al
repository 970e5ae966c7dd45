# A pendulum on a rope that goes slack above the horizontal and becomes taut again (own integration).
# zero: b.z
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body b ball -mass 2 -init_pos {0 -1 0} -init_dpos {5.6 0 0}
force -body b -gravitational {0 -9.81 0}
rope r -points {{0 0 0} {b {0 0 0}}}
