# zero: b.y-0.1
simulator -finish 1
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.3 -surface_velocity {1 0 0}
body b ball -init_pos {0 0.1 0} -mass 1 -restitution 0 -friction 0.3
force -body b -gravitational {0 -9.81 0}
