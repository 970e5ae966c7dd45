# A car on springs drives over a bump. Its wheels roll; each hub slides in the chassis on a spring with a damper.
# The car starts where its springs are slack, and comes to ride 0.049 lower under its weight.

simulator -finish 4
parameter damping -value 150 -min 20 -max 400 -label "dampers" -unit N*s/m

set speed 2
shape_set road -desc {-sub {-box {12 1 1.6}}} -color dimgray
shape_set bump -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 1.2}}} -color orange
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.15 0.1}}} -color black
shape_set hub -desc {-sub {-sphere 0.04}} -color lightgray
shape_set chassis -desc {-sub {-box {1.2 0.15 0.4}}} -color crimson
body road road -fixed 1 -friction 1 -init_pos {4 -0.5 0}
body bump bump -fixed 1 -friction 1 -init_pos {1.5 -0.45 0}

# The parts of the car pass through each other: one -ct.
body chassis chassis -mass 20 -ct 1 -init_pos {0 0.35 0} -init_dpos [list $speed 0 0]
foreach {end x} {rear -0.4 front 0.4} {
    body hub_$end hub -mass 0.5 -ct 1 -init_pos [list $x 0.15 0] -init_dpos [list $speed 0 0]
    body wheel_$end wheel -mass 2 -ct 1 -friction 1 -restitution 0 -init_pos [list $x 0.15 0] \
        -init_dpos [list $speed 0 0] -init_drot [list 0 0 [expr {-$speed/0.15}]]
    joint slide_$end -type slider -body1 hub_$end -body2 chassis -axis {0 1 0} -stiffness 2000 -damping $damping
    joint axle_$end -type hinge -body1 wheel_$end -body2 hub_$end -offset1 {0 0 0}
}
foreach body {chassis hub_rear wheel_rear hub_front wheel_front} {
    force -body $body -gravitational {0 -9.81 0}
}

plot heights -title "Heights above the ride" -values {chassis.y-0.30095 wheel_front.y-0.15} -labels {chassis wheel}
view along -center {chassis.x 0.2 0} -rot {0.32 0 0} -scale 0.8
