# A motor with spring and damper as its law lifts an arm towards 1 rad: the arm's weight leaves it a little below.
simulator -finish 3
shape_set arm -desc {-sub {-box {1 0.1 0.1}}}
body arm arm -mass 2 -init_pos {0.5 0 0}
joint shoulder -type hinge -body1 arm -offset1 {-0.5 0 0} -motor {40*(1 - shoulder.q) - 8*shoulder.dq}
force -body arm -gravitational {0 -9.81 0}
