# A pendulum that is let go at t = 0.7, and one that breaks off when its pin bears 20 N,
# which lets a third one go, too.
# zero: b.y - b.y
simulator -finish 1.2
shape_set rod -desc {-sub {-box {1 0.1 0.1}}}
body a rod -init_pos {0.5 0 0} -mass 1 -inertia {0.01 0.083333333333333333 0.083333333333333333} -ct 1
body c rod -init_pos {0.5 0 6} -mass 1 -ct 1
body b rod -init_pos {0.5 0 3} -mass 1 -inertia {0.01 0.083333333333333333 0.083333333333333333} -ct 1
foreach n {a b c} {force -body $n -gravitational {0 -9.81 0}}
joint let -type hinge -body1 a -offset1 {-0.5 0 0} -release {t > 0.7}
joint break -type hinge -body1 b -offset1 {-0.5 0 0} -release {hypot(break.fx, break.fy) > 20}
joint held -type fixed -body1 c -release {hypot(break.fx, break.fy) > 20}
