# zero: b.z
simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}
body b block -mass 1 -init_pos {0 0.1 0} -friction 0.5 -restitution 0
body w block -mass 1 -init_pos {5 3 0}
joint holds -type fixed -body1 w -release {on.n > 20}
contact on -body1 b -body2 ground
force -body b -gravitational {0 -9.81 0}
force -body w -gravitational {0 -9.81 0}
force -body b -y {-t*10}
