simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set low -desc {-sub {-cylinder {0.15 0.4}}}
body low low -fixed 1 -init_pos {-0.15 -0.2 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.026351407238974923 0.17833292787237498 0.0017234189833003621} -init_rot {0.4 0.2 -0.6} -init_dpos {0.0008158596186374073 0.006157472546760736 0.0} -init_drot {0.6 -3.8 3.0}
force -body b -gravitational {0 -9.81 0}
