# zero: s.y-0.15
simulator -finish 1
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0 
shape_set slab -desc {-sub {-box {0.6 0.3 0.6}}}
shape_set small -desc {-sub {-sphere 0.15}}
body s slab -init_pos {0 0.15 0} -friction 0 -restitution 0
body b small -init_pos {0.05 0.8 0.08} -friction 0 -restitution 0
force -body s -gravitational {0 -9.81 0}
force -body b -gravitational {0 -9.81 0}
