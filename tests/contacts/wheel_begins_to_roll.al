# zero: b.y-0.5
simulator -finish 1
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.25 
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}
shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}
shape_set disc -desc {-sub {-cylinder {0.1 0}}}
shape_set cone -desc {-sub {-cone {0.3 0.8}}}
shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}
body b wheel -init_pos {0 0.5 0} -restitution 0 -friction 0.25 -init_dpos {3 0 0}
force -body b -gravitational {0 -9.81 0}
