simulator -finish 10
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.9 
shape_set drum -desc {-sub {-cylinder {0.3 0.8}}}
body b drum -init_pos {0 0.4 0} -mass 1 -restitution 0 -friction 0.9
force -body b -offset {0 0.4 0} -x 3.6787132124999995
force -body b -gravitational {0 -9.81 0}
