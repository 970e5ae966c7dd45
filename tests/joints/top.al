# A heavy top on a ball joint (own integration of Euler's equations about the point).
# zero: hypot(top.px(0,-0.4,0), top.py(0,-0.4,0), top.pz(0,-0.4,0))
simulator -finish 2
shape_set top -desc {-sub {-box {0.4 0.3 0.4}}}
set s [expr {sin(0.5)}]
set c [expr {cos(0.5)}]
# The spin of 60 about the axis and of 2 about the world's y.
set wx [expr {-60*$s}]
set wy [expr {60*$c + 2}]
body top top -mass 1 -inertia {0.02 0.03 0.02} -init_rot {0 0 0.5} -init_pos [list [expr {-0.4*$s}] [expr {0.4*$c}] 0] \
    -init_dpos [list 0 0 [expr {0.4*($wx*$c + $wy*$s)}]] -init_drot [list $wx $wy 0]
force -body top -gravitational {0 -9.81 0}
joint point -type ball -body1 top -offset1 {0 -0.4 0}
