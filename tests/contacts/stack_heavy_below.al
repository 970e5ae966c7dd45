# zero: b9.y-9.5
simulator -finish 1000
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set block -desc {-sub {-box {1 1 1}}}
body b0 block -mass 1000.0 -init_pos {0.0 0.5 0} -friction 0.5 -restitution 0
body b1 block -mass 464.15888336127773 -init_pos {0.1 1.5 0} -friction 0.5 -restitution 0
body b2 block -mass 215.44346900318845 -init_pos {0.0 2.5 0} -friction 0.5 -restitution 0
body b3 block -mass 100.0 -init_pos {0.1 3.5 0} -friction 0.5 -restitution 0
body b4 block -mass 46.4158883361278 -init_pos {0.0 4.5 0} -friction 0.5 -restitution 0
body b5 block -mass 21.544346900318832 -init_pos {0.1 5.5 0} -friction 0.5 -restitution 0
body b6 block -mass 10.0 -init_pos {0.0 6.5 0} -friction 0.5 -restitution 0
body b7 block -mass 4.6415888336127775 -init_pos {0.1 7.5 0} -friction 0.5 -restitution 0
body b8 block -mass 2.1544346900318843 -init_pos {0.0 8.5 0} -friction 0.5 -restitution 0
body b9 block -mass 1.0 -init_pos {0.1 9.5 0} -friction 0.5 -restitution 0
force -body b0 -gravitational {0 -9.81 0}
force -body b1 -gravitational {0 -9.81 0}
force -body b2 -gravitational {0 -9.81 0}
force -body b3 -gravitational {0 -9.81 0}
force -body b4 -gravitational {0 -9.81 0}
force -body b5 -gravitational {0 -9.81 0}
force -body b6 -gravitational {0 -9.81 0}
force -body b7 -gravitational {0 -9.81 0}
force -body b8 -gravitational {0 -9.81 0}
force -body b9 -gravitational {0 -9.81 0}
