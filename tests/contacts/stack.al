# zero: b5.y-5.5
simulator -finish 20
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set block -desc {-sub {-box {1 1 1}}}
body b0 block -init_pos {0.0 0.5 0} -friction 0.5 -restitution 0
body b1 block -init_pos {0.1 1.5 0} -friction 0.5 -restitution 0
body b2 block -init_pos {0.0 2.5 0} -friction 0.5 -restitution 0
body b3 block -init_pos {0.1 3.5 0} -friction 0.5 -restitution 0
body b4 block -init_pos {0.0 4.5 0} -friction 0.5 -restitution 0
body b5 block -init_pos {0.1 5.5 0} -friction 0.5 -restitution 0
force -body b0 -gravitational {0 -9.81 0}
force -body b1 -gravitational {0 -9.81 0}
force -body b2 -gravitational {0 -9.81 0}
force -body b3 -gravitational {0 -9.81 0}
force -body b4 -gravitational {0 -9.81 0}
force -body b5 -gravitational {0 -9.81 0}
