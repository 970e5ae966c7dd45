# zero: b.y-1
simulator -finish 100
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}
shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}
shape_set disc -desc {-sub {-cylinder {0.1 0}}}
shape_set cone -desc {-sub {-cone {0.3 0.8}}}
shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}
body c wheel -fixed 1 -init_rot {0.7071067811865476 0.0 0.7071067811865475 0.0} -friction 0.5
body b wheel -init_pos {0 1 0} -restitution 0 -friction 0.5
force -body b -gravitational {0 -9.81 0}
