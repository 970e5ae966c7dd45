# A fair's drum turns with 4 rad/s, its floor has been let down: friction alone holds the man on the wall, who presses with m w^2 r.
simulator -finish 3
shape_set drum -desc {-sub {-tube {2 2.1 2}}}
shape_set man -desc {-sub {-box {0.3 1.6 0.4}}}
body drum drum -mass 200 -friction 0.5 -restitution 0
joint axle -type hinge -body1 drum -axis {0 1 0} -speed 4
body man man -mass 80 -friction 0.5 -restitution 0 -init_pos [list [expr {sqrt(4 - 0.04) - 0.15}] 0 0] \
    -init_dpos [list 0 0 [expr {-4*(sqrt(4 - 0.04) - 0.15)}]] -init_drot {0 4 0}
contact wall -body1 man -body2 drum
force -body man -gravitational {0 -9.81 0}
