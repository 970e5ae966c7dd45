simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set low -desc {-sub {-cylinder {0.15 0.4}}}
body low low -fixed 1 -init_pos {-0.15 -0.2 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.08848796910678103 0.15444910300474363 -0.02855440253949422} -init_rot {-0.5 1.1 -0.6} -init_dpos {-0.008290951542795908 -0.012661205515893685 0.0} -init_drot {-3.8 -2.4 -3.6}
force -body b -gravitational {0 -9.81 0}
