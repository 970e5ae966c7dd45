# Two rods (own integration of two angles).
# zero: hypot(one.px(0,0.5,0), one.py(0,0.5,0))
# zero: hypot(one.px(0,-0.5,0) - two.px(0,0.35,0), one.py(0,-0.5,0) - two.py(0,0.35,0))
simulator -finish 4
shape_set one -desc {-sub {-box {0.05 1 0.05}}}
shape_set two -desc {-sub {-box {0.05 0.7 0.05}}}
set a 1.2
set b -0.4
body one one -mass 1 -init_rot [list 0 0 $a] -init_pos [list [expr {0.5*sin($a)}] [expr {-0.5*cos($a)}] 0]
body two two -mass 0.5 -init_rot [list 0 0 $b] \
    -init_pos [list [expr {sin($a) + 0.35*sin($b)}] [expr {-cos($a) - 0.35*cos($b)}] 0]
force -body one -gravitational {0 -9.81 0}
force -body two -gravitational {0 -9.81 0}
joint first -type hinge -body1 one -offset1 {0 0.5 0}
joint second -type hinge -body1 two -offset1 {0 0.35 0} -body2 one -offset2 {0 -0.5 0}
