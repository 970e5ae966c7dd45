# A block of 1 kg slides down a smooth wedge of 2 kg, which is free to slide on a smooth floor. The
# wedge runs back with a = m g sin c cos c / (M + m sin^2 c), and the common centre of mass only sinks.

simulator -finish 0.56

set c 0.5
set long 1.2
set high [expr {$long * tan($c)}]
shape_set wedge -desc "-sub {-points {{0 0 -0.3} {0 $high -0.3} {$long 0 -0.3} {0 0 0.3} {0 $high 0.3} {$long 0 0.3}} -color cornflowerblue}"
shape_set block -desc {-sub {-box {0.24 0.16 0.3} -color darkorange}}
shape_set floor -desc {-sub {-box {3.2 0.06 1.2} -color gainsboro}}
body floor floor -fixed 1 -init_pos {0.5 -0.03 0}
body wedge wedge -mass 2 -restitution 0
# On the slope: 0.16 m from its upper end, along (cos c, -sin c).
set s 0.16
set x [expr {$s*cos($c) + 0.08*sin($c)}]
set y [expr {$high - $s*sin($c) + 0.08*cos($c)}]
body block block -mass 1 -restitution 0 -init_pos [list $x $y 0] -init_rot [list 0 0 -$c]
force -body wedge -gravitational {0 -9.81 0}
force -body block -gravitational {0 -9.81 0}
view side -rot {0.3 -0.08 -0.01}
