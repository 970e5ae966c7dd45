simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.9 
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}
shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}
shape_set disc -desc {-sub {-cylinder {0.1 0}}}
shape_set cone -desc {-sub {-cone {0.3 0.8}}}
shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}
body b disc -init_pos {0.5 0.09553364891256061 0} -init_rot {0.8048354510896435 -0.0 -0.0 -0.5934980174097721} -mass 1 -restitution 0 -friction 0.9 -init_dpos {0 0 -1.0008308978347025} -init_drot {-10.126414395061886 -1.1308052552919405 0}
force -body b -gravitational {0 -9.81 0}
