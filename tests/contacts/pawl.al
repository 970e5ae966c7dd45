# zero: wheel.x
simulator -finish 1
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.4 0.1}}}
shape_set pawl -desc {-sub {-box {0.6 0.05 0.08}}}
body wheel wheel -mass 5 -restitution 0
joint axle -type hinge -body1 wheel -offset1 {0 0 0} -motor 5 -damping 1
body pawl pawl -mass 0.2 -restitution 0 -init_pos {0.3 0.65 0} -init_rot {0 0 -0.3}
joint pin -type hinge -body1 pawl -offset1 {0.3 0 0}
force -body pawl -gravitational {0 -9.81 0}
