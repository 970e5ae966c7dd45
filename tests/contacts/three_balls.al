# zero: l.y-0.5
simulator -finish 10
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.27 
shape_set large -desc {-sub {-sphere 0.5}}
body l large -init_pos {-0.5 0.5 0} -friction 0.27 -restitution 0
body r large -init_pos {0.5 0.5 0} -friction 0.27 -restitution 0
body top large -init_pos {0 1.3660254037844386 0} -friction 0.27 -restitution 0
force -body l -gravitational {0 -9.81 0}
force -body r -gravitational {0 -9.81 0}
force -body top -gravitational {0 -9.81 0}
