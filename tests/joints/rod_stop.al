# A rod on a hinge falls onto a stop at the vertical, e = 0.5 (hits at 0.483333713593, 1.329872271926, 2.155358763246).
# zero: rod.px(-0.5,0,0)
# zero: rod.py(-0.5,0,0)
simulator -finish 4
shape_set rod -desc {-sub {-box {1 0.1 0.1}}}
body rod rod -init_pos {0.5 0 0} -mass 1 -inertia {0.01 0.083333333333333333 0.083333333333333333}
force -body rod -gravitational {0 -9.81 0}
joint pin -type hinge -body1 rod -offset1 {-0.5 0 0} -limits {-1.5707963267948966 {}} -limit_restitution 0.5
