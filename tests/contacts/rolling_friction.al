# zero: b.y-0.1
simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
body b ball -init_pos {0 0.1 0} -init_dpos {1 0 0} -init_drot {0 0 -10} -restitution 0 -friction 0.5 -rolling_friction 0.01
force -body b -gravitational {0 -9.81 0}
