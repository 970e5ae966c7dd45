# Two shafts meet at 0.6 rad in a universal joint (Hooke's, Cardan's). The first turns evenly at 4 rad/s; the
# second runs fast and slow twice each turn: tan q2 = cos b tan q1.

simulator -finish 3

shape_set first -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.06 0.9} -color steelblue} -sub {-pos {0.07 0 -0.3} -box {0.02 0.03 0.2} -color white}}
shape_set second -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.06 0.9} -color firebrick} -sub {-pos {0.07 0 0.3} -box {0.02 0.03 0.2} -color white}}
shape_set bearing -desc {-sub {-pos {0 -0.16 -0.3} -box {0.2 0.2 0.1} -color slategray}}
set c [expr {cos(0.6)}]
set s [expr {sin(0.6)}]
body bearing bearing -fixed 1 -ct 1
body one first -ct 1 -mass 1 -inertia {0.5 0.5 0.3} -center {0 0 0} -init_pos {0 0 -0.5} -init_drot {0 0 4}
body two second -ct 1 -mass 1 -inertia {0.5 0.5 0.3} -center {0 0 0} -init_rot {-0.6 0 0} \
    -init_pos [list 0 [expr {0.5*$s}] [expr {0.5*$c}]] -init_drot [list 0 [expr {4*$c*$s}] [expr {4*$c*$c}]]
joint in -type hinge -body1 one -speed 4
joint out -type hinge -body1 two
joint cross -type universal -body1 one -offset1 {0 0 0.5} -axis {1 0 0} -body2 two -offset2 {0 0 -0.5} -axis2 {0 1 0}

plot rates -title "How fast the shafts turn" -values {in.dq out.dq} -labels {first second}
view side -rot {0.36 -1.21 -0.25}
