# zero: b30.y-3.5
simulator -finish 20
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set block -desc {-sub {-box {1 1 1}}}
body b00 block -init_pos {-1.6500000000000001 0.5 0} -friction 0.5 -restitution 0
body b01 block -init_pos {-0.55 0.5 0} -friction 0.5 -restitution 0
body b02 block -init_pos {0.55 0.5 0} -friction 0.5 -restitution 0
body b03 block -init_pos {1.6500000000000001 0.5 0} -friction 0.5 -restitution 0
body b10 block -init_pos {-1.1 1.5 0} -friction 0.5 -restitution 0
body b11 block -init_pos {0.0 1.5 0} -friction 0.5 -restitution 0
body b12 block -init_pos {1.1 1.5 0} -friction 0.5 -restitution 0
body b20 block -init_pos {-0.55 2.5 0} -friction 0.5 -restitution 0
body b21 block -init_pos {0.55 2.5 0} -friction 0.5 -restitution 0
body b30 block -init_pos {0.0 3.5 0} -friction 0.5 -restitution 0
force -body b00 -gravitational {0 -9.81 0}
force -body b01 -gravitational {0 -9.81 0}
force -body b02 -gravitational {0 -9.81 0}
force -body b03 -gravitational {0 -9.81 0}
force -body b10 -gravitational {0 -9.81 0}
force -body b11 -gravitational {0 -9.81 0}
force -body b12 -gravitational {0 -9.81 0}
force -body b20 -gravitational {0 -9.81 0}
force -body b21 -gravitational {0 -9.81 0}
force -body b30 -gravitational {0 -9.81 0}
