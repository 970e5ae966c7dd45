# Two pendulums with a weak spring between them: the one that is let go hands its swing to the other, and gets it back.
simulator -finish 12
shape_set bob -desc {-sub {-sphere 0.08}}
body one bob -mass 1 -init_rot {0 0 0.2} -init_pos [list [expr {sin(0.2)}] [expr {-cos(0.2)}] 0]
body two bob -mass 1 -init_pos {1 -1 0}
joint first -type hinge -body1 one -offset1 {0 1 0}
joint second -type hinge -body1 two -offset1 {0 1 0}
spring coupling -body1 one -body2 two -stiffness 1 -rest 1
foreach b {one two} {force -body $b -gravitational {0 -9.81 0}}
