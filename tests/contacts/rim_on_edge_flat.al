simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set table -desc {-sub {-box {1 0.5 1}}}
body table table -fixed 1 -init_pos {-0.5 -0.25 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.13527937708749352 0.11869460618931833 0.010539477993827054} -init_rot {0.4 -0.6 -1.1} -init_dpos {-0.01130345948605699 -0.010271680205223347 0.0} -init_drot {1.2 0.7 -3.9}
force -body b -gravitational {0 -9.81 0}
