# A pendulum stands on its head, for its pivot shakes up and down by 2 cm, fast enough (Kapitza): (A w)^2 > 2 g l.
simulator -finish 1
shape_set hand -desc {-sub {-box {0.05 0.02 0.05}}}
shape_set rod -desc {-sub {-box {0.02 0.3 0.02}}}
set a 0.2
body hand hand -mass 1
body rod rod -mass 0.2 -init_rot [list 0 0 $a] -init_pos [list [expr {-0.15*sin($a)}] [expr {0.15*cos($a)}] 0] -init_dpos {0 4 0}
joint shaker -type slider -body1 hand -axis {0 1 0} -position {0.02*sin(200*t)}
joint pivot -type hinge -body1 rod -offset1 {0 -0.15 0} -body2 hand -from $a
force -body rod -gravitational {0 -9.81 0}
