# zero: b2.y-2.5
simulator -finish 1000
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set block -desc {-sub {-box {1 1 1}}}
body b0 block -mass 1000000.0 -init_pos {0.0 0.5 0} -friction 0.5 -restitution 0
body b1 block -mass 1 -init_pos {0.1 1.5 0} -friction 0.5 -restitution 0
body b2 block -mass 1000000.0 -init_pos {0.0 2.5 0} -friction 0.5 -restitution 0
force -body b0 -gravitational {0 -9.81 0}
force -body b1 -gravitational {0 -9.81 0}
force -body b2 -gravitational {0 -9.81 0}
