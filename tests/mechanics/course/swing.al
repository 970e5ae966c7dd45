# A child on a swing stands up and crouches, twice for each time to and fro, and swings ever higher without a push.
simulator -finish 10
shape_set rod -desc {-sub {-box {0.02 2 0.02}}}
shape_set child -desc {-sub {-sphere 0.25}}
set a 0.2
body rod rod -mass 1 -init_rot [list 0 0 $a] -init_pos [list [expr {sin($a)}] [expr {-cos($a)}] 0]
body child child -mass 30 -ct 1 -init_rot [list 0 0 $a] -init_pos [list [expr {2*sin($a)}] [expr {-2*cos($a)}] 0]
joint hook -type hinge -body1 rod -offset1 {0 1 0} -from $a
joint knees -type slider -body1 child -body2 rod -axis {0 1 0} -position {0.1*(1 - cos(4.4*t))}
foreach b {rod child} {force -body $b -gravitational {0 -9.81 0}}
