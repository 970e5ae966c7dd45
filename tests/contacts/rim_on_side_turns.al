simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set log -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.2 1}}}
body log log -fixed 1 -init_pos {0 -0.2 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.010242034792164522 0.17241954048981373 -0.05163915937152326} -init_rot {-0.8 0.5 -0.4} -init_dpos {0.0 0.03819581851849919 0.0} -init_drot {0.7 -3.1 0.2}
force -body b -gravitational {0 -9.81 0}
