# zero: b.x
# zero: b.z
simulator -finish 1.9
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0 
shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}
body b block -mass 2 -init_pos {0 0.1 0} -restitution 0
contact k -body1 b -body2 ground
force -body b -gravitational {0 -9.81 0}
force -body b -x {-3*sign(b.dx) + 1.5*t} -y {-9*sign(b.dx)}
