# A rod falls aslant on smooth ground: one end strikes and turns it.
simulator -finish 0.55
shape_set ground -desc {-sub {-plane}}
shape_set rod -desc {-sub {-rot {0 0 1.5708} -capsule {0.02 1}}}
body floor ground -fixed 1
body rod rod -mass 1 -inertia {0.001 0.09 0.09} -center {0 0 0} -restitution 0.5 -init_pos {0 1.5 0} -init_rot {0 0 0.5}
force -body rod -gravitational {0 -9.81 0}
