# A governor: two arms on a spindle with a motor, a sleeve that massless rods lift and a spring presses (own integration of two angles).
# zero: hypot(right.px(0,0.25,0), right.py(0,0.25,0), right.pz(0,0.25,0))
# zero: hypot(left.px(0,-0.25,0)-sleeve.x, left.py(0,-0.25,0)-sleeve.y, left.pz(0,-0.25,0)-sleeve.z) - 0.5
# zero: hypot(sleeve.x, sleeve.z)
simulator -finish 3
shape_set spindle -desc {-sub {-box {0.05 0.6 0.05}}}
shape_set arm -desc {-sub {-box {0.05 0.5 0.05}}}
shape_set sleeve -desc {-sub {-box {0.1 0.05 0.1}}}
set a 0.8
set s [expr {sin($a)}]
set c [expr {cos($a)}]
body spindle spindle -mass 1 -inertia {0.1 0.05 0.1} -init_drot {0 9 0}
body right arm -ct 1 -mass 0.8 -inertia {0.03 0.004 0.03} -init_rot [list 0 0 $a] -init_pos [list [expr {0.25*$s}] [expr {-0.25*$c}] 0] \
    -init_dpos [list 0 0 [expr {-9*0.25*$s}]] -init_drot {0 9 0}
body left arm -ct 1 -mass 0.8 -inertia {0.03 0.004 0.03} -init_rot [list 0 0 [expr {-$a}]] -init_pos [list [expr {-0.25*$s}] [expr {-0.25*$c}] 0] \
    -init_dpos [list 0 0 [expr {9*0.25*$s}]] -init_drot {0 9 0}
body sleeve sleeve -mass 0.5 -inertia {0.01 0.02 0.01} -init_pos [list 0 [expr {-$c}] 0] -init_drot {0 9 0}
foreach name {right left sleeve} {force -body $name -gravitational {0 -9.81 0}}
joint axle -type hinge -body1 spindle -axis {0 1 0} -motor {0.5*sin(2*t)}
joint slide -type slider -body1 sleeve -body2 spindle -axis {0 1 0} -stiffness 30 -rest 0.1
joint upper1 -type hinge -body1 right -offset1 {0 0.25 0} -body2 spindle
joint upper2 -type hinge -body1 left -offset1 {0 0.25 0} -body2 spindle
joint lower1 -type distance -body1 right -offset1 {0 -0.25 0} -body2 sleeve
joint lower2 -type distance -body1 left -offset1 {0 -0.25 0} -body2 sleeve
