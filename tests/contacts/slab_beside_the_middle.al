# zero: b.y-0.45
simulator -finish 10
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set slab -desc {-sub {-box {0.6 0.3 0.6}}}
body s slab -init_pos {0 0.15 0} -friction 0.5 -restitution 0
body b slab -init_pos {0 0.45 0.2} -friction 0.5 -restitution 0
force -body s -gravitational {0 -9.81 0}
force -body b -gravitational {0 -9.81 0}
