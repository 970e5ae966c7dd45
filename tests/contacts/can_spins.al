# zero: b.y-0.2
simulator -finish 2
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.1 
shape_set can -desc {-sub {-cylinder {0.2 0.4}}}
body b can -init_pos {0 0.2 0} -init_drot {0 10 0} -restitution 0 -friction 0.1
force -body b -gravitational {0 -9.81 0}
