# A robot's arm of two links moves to a place and stays there: the motor of each joint pulls towards its
# angle, brakes, and carries the weight. Without error of the weight, the arm ends at 1 rad and -1.2 rad.
# The way there is an own integration of the two angles.

parameter shoulder_angle -value 1 -min -1 -max 2 -label "angle of the shoulder" -unit rad
parameter elbow_angle -value -1.2 -min -2.5 -max 2.5 -label "angle of the elbow" -unit rad
simulator -finish 3

shape_set upper -desc {-sub {-box {0.5 0.09 0.09} -color darkorange} -sub {-pos {-0.25 0 0} -rot {1.5707963267948966 0 0} -cylinder {0.08 0.12} -color dimgray}
    -sub {-pos {0.25 0 0} -rot {1.5707963267948966 0 0} -cylinder {0.06 0.12} -color dimgray}}
shape_set fore -desc {-sub {-box {0.4 0.06 0.06} -color gold} -sub {-pos {0.22 0.03 0} -box {0.06 0.02 0.06} -color dimgray}
    -sub {-pos {0.22 -0.03 0} -box {0.06 0.02 0.06} -color dimgray}}
shape_set base -desc {-sub {-pos {0 -0.3 0} -cylinder {0.1 0.5} -color slategray} -sub {-pos {0 -0.58 0} -cylinder {0.25 0.06} -color slategray}}
body base base -fixed 1 -ct 1
body upper upper -ct 1 -mass 4 -inertia {0.01 0.09 0.09} -center {0 0 0} -init_pos {0.25 0 0}
body fore fore -ct 1 -mass 2 -inertia {0.004 0.03 0.03} -center {0 0 0} -init_pos {0.7 0 0}
foreach name {upper fore} {force -body $name -gravitational {0 -9.81 0}}
joint shoulder -type hinge -body1 upper -offset1 {-0.25 0 0} \
    -motor {60*(shoulder_angle - shoulder.q) - 18*shoulder.dq + 9.81*(upper.mass*upper.x + fore.mass*fore.x)}
joint elbow -type hinge -body1 fore -offset1 {-0.2 0 0} -body2 upper -offset2 {0.25 0 0} \
    -motor {20*(elbow_angle - elbow.q) - 4*elbow.dq + 9.81*fore.mass*(fore.x - fore.px(-0.2,0,0))}

plot angles -title "Angles of the arm" -values {shoulder.q elbow.q} -labels {shoulder elbow}
view front -rot {0.19 -0.18 -0.02}
