# On a turning chair one draws two weights of 5 kg in, from 0.8 m to 0.3 m. Nothing turns the chair from
# outside, so that the angular momentum stays what it is, and it turns 2.5 times as fast.

simulator -finish 3

shape_set chair -desc {-sub {-pos {0 -0.42 0} -cylinder {0.25 0.06} -color saddlebrown} -sub {-pos {0 -0.62 0} -cylinder {0.04 0.36} -color dimgray}
    -sub {-pos {0 -0.1 0} -cylinder {0.16 0.6} -color royalblue} -sub {-pos {0 0.33 0} -sphere 0.13 -color burlywood}}
shape_set foot -desc {-sub {-cylinder {0.35 0.06} -color dimgray}}
shape_set weight -desc {-sub {-sphere 0.1 -color goldenrod}}
body foot foot -fixed 1 -ct 1 -init_pos {0 -0.83 0}
body chair chair -ct 1 -mass 60 -inertia {5 2.7 5} -center {0 0 0} -init_drot {0 2 0}
joint axle -type hinge -body1 chair -axis {0 1 0}
foreach {name side} {right 1 left -1} {
    body $name weight -ct 1 -mass 5 -init_pos [list [expr {0.8*$side}] 0 0] -init_dpos [list 0 0 [expr {-1.6*$side}]] -init_drot {0 2 0}
    joint arm_$name -type slider -body1 $name -body2 chair -axis [list $side 0 0] \
        -position {t < 1 ? 0 : t < 2 ? -0.25*(1 - cos(pi*(t - 1))) : -0.5}
}

plot speed -title "How fast the chair turns, in turns for each second" -values {axle.dq/(2*pi)} -labels {chair}
view above -rot {0.41 -0.17 -0.04}
