# A race down a slope: who rolls, lets a part of its fall go into turning. A ball rolls with 5/7 of
# g sin a, a solid cylinder with 2/3, a hoop with 1/2; size and mass do not count.

parameter slope -value 0.2 -min 0.05 -max 0.4 -label "slope of the board" -unit rad
simulator -finish 1.6

set c [expr {cos($slope)}]
set s [expr {sin($slope)}]
set across [expr {acos(-1) / 2}]
shape_set board -desc {-sub {-box {3 0.08 1.5} -color burlywood}}
shape_set ball -desc {-sub {-sphere 0.12 -color crimson} -sub {-pos {0.07 0 0.092} -sphere 0.015 -color white}}
shape_set cylinder -desc "-sub {-rot {$across 0 0} -cylinder {0.12 0.2} -color steelblue}
    -sub {-pos {0.08 0 0.103} -rot {$across 0 0} -cylinder {0.015 0.006} -color white}"
shape_set hoop -desc "-sub {-rot {$across 0 0} -cylinder {0.12 0.1} -color goldenrod}
    -sub {-pos {0 0 0.053} -rot {$across 0 0} -cylinder {0.105 0.006} -color black}
    -sub {-pos {0.08 0 0.059} -rot {$across 0 0} -cylinder {0.015 0.006} -color white}"
body board board -fixed 1 -init_pos [list [expr {1.3*$c - 0.04*$s}] [expr {-1.3*$s - 0.04*$c}] 0] -init_rot [list 0 0 -$slope] \
    -friction 0.5
foreach {name z about} {ball 0.45 0.00576 cylinder 0 0.0072 hoop -0.45 0.0144} {
    body $name $name -mass 1 -inertia [list $about $about $about] -center {0 0 0} -restitution 0 -friction 0.5 \
        -init_pos [list [expr {0.12*$s}] [expr {0.12*$c}] $z]
    force -body $name -gravitational {0 -9.81 0}
}
plot way -title "Way down the board" -values {hypot(ball.x,ball.y) hypot(cylinder.x,cylinder.y) hypot(hoop.x,hoop.y)} \
    -labels {ball cylinder hoop}
view above -rot {0.48 -0.17 -0.04}
