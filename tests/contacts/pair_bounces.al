# zero: a.z
simulator -finish 0.5
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0 -ct 1
body a ball -init_pos {-1 0.5 0} 
body b ball -init_pos {0 0.5 0} -ct 1
body c ball -init_pos {1 0.5 0} 
force -body a -gravitational {0 -9.81 0}
force -body b -gravitational {0 -9.81 0}
force -body c -gravitational {0 -9.81 0}
contact soft -body1 ground -body2 a -restitution 0.5
contact -body1 b -body2 ground -collide 1
contact -body1 c -body2 ground -collide 0
