# An arm whose servos bear 10 Nm at most lifts itself: the shoulder slips, and keeps what it has slipped.
# zero: l0.x+l0.z
simulator -finish 3.1 -collisions 0
shape_set l -desc {-sub {-box {0.08 0.4 0.08}}}
body l0 l -fixed 1 -init_pos {0 0.2 0}
body l1 l -mass 2 -init_pos {0 0.6 0}
body l2 l -mass 2 -init_pos {0 1.0 0}
joint j1 -type hinge -body1 l1 -offset1 {0 -0.2 0} -body2 l0 -axis {0 0 1} -position {0.5*(1-cos(2*t))} -max_motor 10
joint j2 -type hinge -body1 l2 -offset1 {0 -0.2 0} -body2 l1 -axis {0 0 1} -position {0.5*(1-cos(2*t))} -max_motor 10
foreach b {l1 l2} {force -body $b -gravitational {0 -9.81 0}}
