# A round cam turns about a pin beside its centre and lifts a follower, which rests on it by its weight: the
# follower rises as e sin(w t). At over 9.9 rad/s, where e w^2 is more than g, it would jump.

parameter speed -value 4 -min 1 -max 14 -label "the cam's speed" -unit rad/s
simulator -finish 4

set quarter [expr {acos(-1)/2}]
shape_set cam -desc "-sub {-rot {$quarter 0 0} -cylinder {0.3 0.1} -color steelblue}
    -sub {-pos {-0.1 0 0.07} -rot {$quarter 0 0} -cylinder {0.03 0.04} -color white} -sub {-pos {0.2 0 0.065} -rot {$quarter 0 0} -cylinder {0.02 0.03} -color gold}"
shape_set follower -desc {-sub {-box {0.5 0.06 0.1} -color firebrick} -sub {-pos {0 0.43 0} -box {0.08 0.8 0.08} -color firebrick}}
shape_set guide -desc {-sub {-pos {-0.08 0 0} -box {0.06 0.25 0.16} -color dimgray} -sub {-pos {0.08 0 0} -box {0.06 0.25 0.16} -color dimgray}}
shape_set base -desc {-sub {-box {1 0.06 0.5} -color slategray}}
body base base -fixed 1 -ct 1 -init_pos {0 -0.5 0}
body guide guide -fixed 1 -ct 1 -init_pos {0 0.85 0}
body cam cam -mass 2 -init_pos {0.1 0 0}
joint axle -type hinge -body1 cam -offset1 {-0.1 0 0} -speed {speed}
body follower follower -mass 1 -restitution 0 -ct 1 -init_pos {0 0.33 0}
joint rail -type slider -body1 follower -axis {0 1 0}
contact touch -body1 follower -body2 cam
force -body follower -gravitational {0 -9.81 0}

plot lift -title "Lift of the follower and force on the cam" -values {100*rail.q touch.n} -labels {cm N}
view front -rot {0.08 -0.17 -0.01}
