# A body swings about an axis along which a force of 2 sin 3t moves it (own integration of the angle, closed form of the slide).
# zero: hypot(arm.py(0,0.3,0), arm.pz(0,0.3,0))
simulator -finish 4
shape_set arm -desc {-sub {-box {0.1 0.6 0.1}}}
body arm arm -mass 1.5 -inertia {0.06 0.01 0.06} -init_pos {0 -0.3 0} -init_dpos {0.4 0 -1.2} -init_drot {4 0 0}
force -body arm -gravitational {0 -9.81 0}
joint rail -type cylindrical -body1 arm -offset1 {0 0.3 0} -axis {1 0 0} -motor2 {2*sin(3*t)}
