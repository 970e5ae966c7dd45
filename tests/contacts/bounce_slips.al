# zero: b.z
simulator -finish 0.3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.2 -restitution 0.8
body b ball -init_pos {0 0.5 0} -init_dpos {1 -4 0} -init_drot {0 0 50} -friction 0.2 -mass 1 -restitution 0.8
