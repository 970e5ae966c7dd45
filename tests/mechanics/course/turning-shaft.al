# A rod hangs by a hinge on a shaft that a motor turns with 6 rad/s: it swings up and down about the angle at which it could stay.
simulator -finish 4
shape_set shaft -desc {-sub {-cylinder {0.02 0.4}}}
shape_set rod -desc {-sub {-box {0.04 1 0.04}}}
set a 0.3
body shaft shaft -mass 1
body rod rod -mass 1 -init_pos [list [expr {0.5*sin($a)}] [expr {-0.5*cos($a)}] 0] -init_rot [list 0 0 $a] \
    -init_dpos [list 0 0 [expr {-3*sin($a)}]] -init_drot {0 6 0}
joint motor -type hinge -body1 shaft -axis {0 1 0} -speed 6
joint pin -type hinge -body1 rod -offset1 {0 0.5 0} -body2 shaft -from 0.3
force -body rod -gravitational {0 -9.81 0}
