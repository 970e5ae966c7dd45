simulator -start 0 -finish 3
shape_set ball -desc {-sub {-sphere 0.5}}
body b ball -init_pos {1 2 3} -init_dpos {1 4 0}
force -body b -gravitational {0 -9.81 0}
