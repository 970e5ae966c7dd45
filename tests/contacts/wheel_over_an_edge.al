simulator -finish 0.8
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}
shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}
shape_set disc -desc {-sub {-cylinder {0.1 0}}}
shape_set cone -desc {-sub {-cone {0.3 0.8}}}
shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}
shape_set table -desc {-sub {-box {2 1 2}}}
body table table -fixed 1 -init_pos {-1 -0.5 0}
body b wheel -init_pos {-0.5 0.5 0} -init_dpos {1 0 0} -restitution 0
force -body b -gravitational {0 -9.81 0}
