simulator -finish 2
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 1 
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}
shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}
shape_set disc -desc {-sub {-cylinder {0.1 0}}}
shape_set cone -desc {-sub {-cone {0.3 0.8}}}
shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}
body b cone -init_pos {0.15576733692346023 0.3684243976011541 0} -init_rot {0.19866933079506124 0.0 0.0 0.9800665778412416} -mass 1 -restitution 0 -friction 1 -inertia {0.01 0.02 0.01} -init_dpos {0 0 -0.24364193383020638} -init_drot {116.45148755633777 276.47642926418064 0}
force -body b -gravitational {0 -9.81 0}
