# A pendulum on a rope that breaks at a tension of 20 (own integration).
# zero: b.z
simulator -finish 1
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body b ball -mass 1 -init_pos {1 0 0}
force -body b -gravitational {0 -9.81 0}
rope r -points {{0 0 0} {b {0 0 0}}} -release {r.tension > 20}
