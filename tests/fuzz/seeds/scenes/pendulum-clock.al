# Parameters: two pendulums, one on the Earth and one where gravity and length are yours to choose
# (move the sliders). Expressions and the script read the same names: g in the force, $length where the
# rod is made. A rod with a bob, hung on a stiff link.

simulator -finish 15 -collisions 0

parameter g -value 3.7 -min 0 -max 25 -label "gravity" -unit m/s^2
parameter length -value 2 -min 0.5 -max 4 -label "length of the rod" -unit m

proc pendulum {name length acceleration x color} {
    set bob 0.25
    shape_set $name-shape -desc [list \
        -sub [list -pos [list 0 [expr {($bob - $length) / 2.0}] 0] -box [list 0.06 [expr {$length - $bob}] 0.06] -color gray] \
        -sub [list -pos [list 0 [expr {-1.0 * $length}] 0] -sphere $bob -color $color]]
    # Turned aside by half a radian about the point it hangs on, which is the shape's origin.
    body $name $name-shape -init_pos [list $x 0 0] -init_rot {0 0 0.5}
    link -body1 $name -offset1 {0 0 0} -x $x -y 0 -z 0 -tightness 20000
    force -body $name -y "-$acceleration * $name.mass"
}

pendulum earth 2 9.81 -2 royalblue
pendulum there $length g 2 orangered

plot swing -title "Swing of the two" -values {earth.px(0,-2,0)+2 there.px(0,-length,0)-2} \
    -labels {Earth there}
