# A weight on a spring of beads: each bead is tied to the next by a link, whose -tightness says how stiff
# it is.

simulator -finish 12 -collisions 0

set beads 11
set apart 0.16
set tightness 700

shape_set beam -desc {-sub {-box {1.4 0.12 0.6}}} -color slategray
shape_set bead -desc {-sub {-sphere 0.07}} -color goldenrod -shininess 0.6
shape_set weight -desc {-sub {-box {0.7 0.5 0.5}}} -color crimson

body beam1 beam -fixed 1 -init_pos {0 0.06 0}
set above {-x 0 -y 0 -z 0}
for {set i 1} {$i <= $beads} {incr i} {
    body bead$i bead -mass 0.02 -init_pos [list 0 [expr {-$apart * $i}] 0]
    # Half of the way is the bead's own, so that the spring has a length at rest.
    link -body1 bead$i -offset1 [list 0 $apart 0] {*}$above -tightness $tightness -damping 0
    force -body bead$i -gravitational {0 -9.81 0}
    set above [list -body2 bead$i -offset2 {0 0 0}]
}
body weight1 weight -mass 1 -init_pos [list 0 [expr {-$apart * $beads - 0.25}] 0]
link -body1 weight1 -offset1 {0 0.25 0} {*}$above -tightness $tightness -damping 0
force -body weight1 -gravitational {0 -9.81 0}

view front -rot {0.1 0 0}
