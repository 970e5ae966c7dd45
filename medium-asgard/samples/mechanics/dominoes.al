# Six dominoes fall one after the other. The first stands on its edge, tilted beyond its balance. Friction
# holds their feet, and they slide on each other. The last one falls flat on the table, and slides on.

simulator -finish 1.6

set tilt 0.2
shape_set stone -desc {-sub {-box {0.06 0.4 0.2}}} -color ivory
shape_set table -desc {-sub {-box {2.6 0.1 0.8}}} -color burlywood
body table table -fixed 1 -friction 0.6 -init_pos {0.75 -0.05 0}
# The first turns about its lower right edge, at x = 0.03.
set s [expr {sin($tilt)}]
set c [expr {cos($tilt)}]
for {set i 0} {$i < 6} {incr i} {
    set x [expr {$i > 0 ? 0.25*$i : 0.03 - 0.03*$c + 0.2*$s}]
    set y [expr {$i > 0 ? 0.2 : 0.03*$s + 0.2*$c}]
    set turn [expr {$i > 0 ? 0 : -$tilt}]
    body d$i stone -mass 0.5 -restitution 0 -friction 0.2 -static_friction 0.6 -init_pos [list $x $y 0] -init_rot [list 0 0 $turn]
    force -body d$i -gravitational {0 -9.81 0}
}

plot heights -title "Heights of the centres, in m" -values {d0.y d2.y d5.y} -labels {first third last}
view front -rot {0.2 0 0}
