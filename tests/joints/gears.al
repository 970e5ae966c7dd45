# A pair of wheels with a motor, a differential, and a weight on a rack (closed forms).
# zero: one.q + 2*two.q
# zero: left.q + right.q - 2*cage.q
# zero: fall.q - 0.2*drum.q
simulator -finish 3
shape_set wheel -desc {-sub {-box {0.4 0.4 0.1}}}
foreach {name x inertia} {w1 0 0.3 w2 1 0.5 w3 2 0.2 w4 3 0.7 w5 4 0.4 w6 5 0.25} {
    body $name wheel -mass 1 -inertia [list 1 1 $inertia] -init_pos [list $x 0 0]
}
body weight wheel -mass 2 -init_pos {6 0 0}
force -body weight -gravitational {0 -9.81 0}
joint one -type hinge -body1 w1
joint two -type hinge -body1 w2 -motor {2*cos(3*t)}
gear pair -joint1 one -joint2 two -ratio -2
joint left -type hinge -body1 w3 -motor 0.3
joint right -type hinge -body1 w4
joint cage -type hinge -body1 w5 -motor 1
gear differential -joints {left right cage} -ratios {1 1 -2}
joint drum -type hinge -body1 w6
joint fall -type slider -body1 weight -axis {0 1 0}
gear rack -joint1 fall -joint2 drum -ratio 0.2
