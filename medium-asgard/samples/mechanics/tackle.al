# A tackle: 10 kg hang on four strands of one rope, and 3 kg at its end are more than a quarter of that.
# So the load rises, a quarter as fast as the end sinks: a = (4 m - M) g / (16 m + M + 15 w), where the
# load's two sheaves (w = 0.1 kg each) count in M. Wheel after wheel turns 1, 2, 3 and 4 times as fast.

parameter pull -value 3 -min 2.6 -max 5 -label "weight at the end" -unit kg
simulator -finish 1.2

set half_turn [expr {acos(-1) / 2}]
shape_set sheave -desc "-sub {-rot {$half_turn 0 0} -cylinder {0.06 0.03} -color steelblue}
    -sub {-pos {0.035 0 0.018} -rot {$half_turn 0 0} -cylinder {0.012 0.006} -color white}"
shape_set beam -desc {-sub {-pos {0 0.14 0} -box {1 0.08 0.24} -color saddlebrown}
    -sub {-pos {-0.12 0.04 -0.04} -box {0.04 0.12 0.02} -color gray} -sub {-pos {0.12 0.04 -0.04} -box {0.04 0.12 0.02} -color gray}
    -sub {-pos {-0.3 0.08 0} -box {0.03 0.04 0.03} -color gray}}
shape_set load -desc {-sub {-box {0.4 0.24 0.24} -color firebrick}
    -sub {-pos {-0.12 0.16 -0.04} -box {0.04 0.08 0.02} -color gray} -sub {-pos {0.12 0.16 -0.04} -box {0.04 0.08 0.02} -color gray}}
shape_set weight -desc {-sub {-cylinder {0.05 0.16} -color goldenrod} -sub {-pos {0 0.095 0} -cylinder {0.012 0.03} -color gray}}

body beam beam -fixed 1
body load load -mass 10 -init_pos {-0.12 -1.4 0}
joint rail -type slider -body1 load -axis {0 1 0}
foreach {name x y} {low1 -0.24 -1.2 top1 -0.12 0 low2 0 -1.2 top2 0.12 0} {
    body $name sheave -ct 1 -mass 0.1 -inertia {0.0001 0.0001 0.00018} -center {0 0 0} -init_pos [list $x $y 0]
}
joint pin1 -type hinge -body1 low1 -body2 load
joint pin2 -type hinge -body1 top1
joint pin3 -type hinge -body1 low2 -body2 load
joint pin4 -type hinge -body1 top2
body end weight -mass $pull -init_pos {0.18 -0.4 0}
rope line -points {{-0.3 0.06 0} {low1 {0 0 0} 0.06} {top1 {0 0 0} 0.06} {low2 {0 0 0} 0.06} {top2 {0 0 0} 0.06} {end {0 0.11 0}}}
foreach name {load low1 low2 end} {force -body $name -gravitational {0 -9.81 0}}

plot tension -title "Tension at both ends of the rope" -values {line.tension1 line.tension5} -labels {beam weight}
view front -rot {0.08 -0.11 0}
