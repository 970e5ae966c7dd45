# Hooke's joint between shafts inclined by 0.6, the first one held at 4 rad/s (closed form).
# zero: hypot(one.x, one.y, one.z)
# zero: hypot(two.px(0,0,-0.5), two.py(0,0,-0.5), two.pz(0,0,-0.5))
simulator -finish 3
shape_set shaft -desc {-sub {-box {0.1 0.1 1}}}
set c [expr {cos(0.6)}]
set s [expr {sin(0.6)}]
body one shaft -mass 1 -init_drot {0 0 4}
body two shaft -mass 1 -inertia {0.5 0.5 0.3} -init_rot {-0.6 0 0} -init_pos [list 0 [expr {0.5*$s}] [expr {0.5*$c}]] \
    -init_drot [list 0 [expr {4*$c*$s}] [expr {4*$c*$c}]]
joint in -type hinge -body1 one -speed 4
joint out -type hinge -body1 two
joint cross -type universal -body1 one -offset1 {0 0 0} -axis {1 0 0} -body2 two -offset2 {0 0 -0.5} -axis2 {0 1 0}
