# Watt's governor: the spindle turns, two balls fly outwards, and their rods lift a sleeve against a
# spring and gravity. A motor drives the spindle faster and slower. The answer is an own integration.

simulator -finish 3

shape_set spindle -desc {-sub {-pos {0 -0.35 0} -cylinder {0.02 1.1} -color gray} -sub {-pos {0 0.03 0} -cylinder {0.05 0.06} -color dimgray}}
shape_set arm -desc {-sub {-cylinder {0.015 0.5} -color goldenrod} -sub {-pos {0 -0.25 0} -sphere 0.07 -color firebrick}}
shape_set sleeve -desc {-sub {-cylinder {0.07 0.08} -color steelblue}}
shape_set foot -desc {-sub {-pos {0 -1.25 0} -cylinder {0.25 0.1} -color slategray} -sub {-pos {0 -1.05 0} -cylinder {0.04 0.3} -color slategray}}
set a 0.8
set s [expr {sin($a)}]
set c [expr {cos($a)}]
body foot foot -fixed 1 -ct 1
body spindle spindle -ct 1 -mass 1 -inertia {0.1 0.05 0.1} -center {0 0 0} -init_drot {0 9 0}
body right arm -ct 1 -mass 0.8 -inertia {0.03 0.004 0.03} -center {0 0 0} -init_rot [list 0 0 $a] \
    -init_pos [list [expr {0.25*$s}] [expr {-0.25*$c}] 0] -init_dpos [list 0 0 [expr {-9*0.25*$s}]] -init_drot {0 9 0}
body left arm -ct 1 -mass 0.8 -inertia {0.03 0.004 0.03} -center {0 0 0} -init_rot [list 0 0 -$a] \
    -init_pos [list [expr {-0.25*$s}] [expr {-0.25*$c}] 0] -init_dpos [list 0 0 [expr {9*0.25*$s}]] -init_drot {0 9 0}
body sleeve sleeve -ct 1 -mass 0.5 -inertia {0.01 0.02 0.01} -init_pos [list 0 -$c 0] -init_drot {0 9 0}
foreach name {right left sleeve} {force -body $name -gravitational {0 -9.81 0}}
joint axle -type hinge -body1 spindle -axis {0 1 0} -motor {0.5*sin(2*t)}
joint slide -type slider -body1 sleeve -body2 spindle -axis {0 1 0} -stiffness 30 -rest 0.1
joint upper1 -type hinge -body1 right -offset1 {0 0.25 0} -body2 spindle
joint upper2 -type hinge -body1 left -offset1 {0 0.25 0} -body2 spindle
joint lower1 -type distance -body1 right -offset1 {0 -0.25 0} -body2 sleeve
joint lower2 -type distance -body1 left -offset1 {0 -0.25 0} -body2 sleeve

plot sleeve -title "Height of the sleeve, and speed" -values {slide.q axle.dq/20} -labels {sleeve "speed / 20"}
view front -rot {0.2 -0.22 -0.02}
