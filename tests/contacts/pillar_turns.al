# zero: b.qx
simulator -finish 0.05
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set pillar -desc {-sub {-box {1 4 1}}}
body b pillar -init_pos {0 2 0} -init_dpos {1 0 0} -init_drot {0 20 0} -restitution 0 -friction 0.5
force -body b -gravitational {0 -9.81 0}
