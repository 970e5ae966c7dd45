# A piston engine: the motor turns the crank (0.1 m) with 1.5 N m, the rod (0.3 m) drives the piston to and
# fro; a brake takes 0.1 N m s. All parts have mass, so the crank runs unevenly, at 15 rad/s in the mean. The answer is an own integration of the one angle.

parameter torque -value 1.5 -min 0.5 -max 5 -label "torque of the motor" -unit N*m
simulator -finish 2

shape_set crank -desc {-sub {-box {0.14 0.04 0.02} -color firebrick}}
shape_set rod -desc {-sub {-pos {0 0 0.025} -box {0.33 0.03 0.02} -color goldenrod}}
shape_set piston -desc {-sub {-box {0.12 0.09 0.09} -color steelblue}}
shape_set block -desc {-sub {-pos {0.33 -0.07 0} -box {0.46 0.03 0.16} -color slategray} -sub {-pos {0 -0.1 -0.05} -box {0.06 0.26 0.04} -color slategray}
    -sub {-pos {0.2 -0.24 0} -box {0.8 0.03 0.2} -color slategray}}
body block block -fixed 1 -ct 1
body crank crank -ct 1 -mass 0.5 -inertia {0.0001 0.00045 0.0005} -center {0 0 0} -init_pos {0.05 0 0}
body rod rod -ct 1 -mass 0.4 -inertia {0.0001 0.003 0.003} -center {0 0 0} -init_pos {0.25 0 0}
body piston piston -ct 1 -mass 0.8 -init_pos {0.4 0 0}
foreach name {crank rod piston} {force -body $name -gravitational {0 -9.81 0}}
joint axle -type hinge -body1 crank -offset1 {-0.05 0 0} -motor torque -damping 0.1
joint pin -type hinge -body1 rod -offset1 {-0.15 0 0} -body2 crank -offset2 {0.05 0 0}
joint gudgeon -type hinge -body1 rod -offset1 {0.15 0 0} -body2 piston -offset2 {0 0 0}
joint bore -type slider -body1 piston -axis {1 0 0}

plot speed -title "Speed of the crank" -values {axle.dq} -labels {crank}
view front -rot {0.29 -0.16 -0.02}
