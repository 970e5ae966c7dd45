# zero: b.qx
simulator -finish 1
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.3 
shape_set loaded -desc {-sub {-box {1 0.2 1}} -sub {-pos {0 0.2 0.4} -density 20 -box {0.2 0.2 0.2}}}
body b loaded -init_pos {0 0.1 0} -init_dpos {2 0 0} -restitution 0 -friction 0.3
force -body b -gravitational {0 -9.81 0}
