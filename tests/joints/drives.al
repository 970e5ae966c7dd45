# An arm held to 0.5 sin 2t under gravity, a slide held by a trajectory, a wheel that follows the arm (closed forms).
# zero: lift.q - 0.5*sin(2*t)
# zero: follow.dq - 3*lift.dq
simulator -finish 2
shape_set arm -desc {-sub {-box {1 0.1 0.1}}}
shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}
body arm arm -mass 2 -inertia {0.1 0.2 0.2} -init_pos {0.5 0 0} -init_dpos {0 0.5 0} -init_drot {0 0 1}
body slide box -mass 3 -init_pos {0 1 0}
body wheel box -mass 1 -inertia {1 1 0.4} -init_pos {0 2 0} -init_drot {0 0 3}
force -body arm -gravitational {0 -9.81 0}
trajectory way -bezier {{0 2 {0 0 0} {0 0 0} {1 0 0}}}
joint lift -type hinge -body1 arm -offset1 {-0.5 0 0} -position {0.5*sin(2*t)}
joint carry -type slider -body1 slide -axis {1 0 0} -position way
joint follow -type hinge -body1 wheel -speed {3*lift.dq}
