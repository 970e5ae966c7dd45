# A ladder of 2 m leans on a smooth wall and stands on a smooth floor, and nobody holds its foot. Its
# middle moves on a circle until the wall would have to pull: there it leaves the wall, at 0.601 s, and
# its foot slides on at the speed that it has.

simulator -finish 0.85

# It leans at 70 degrees; its middle is half a length from the lower corner.
set a [expr {70 * acos(-1) / 180}]
shape_set ladder -desc {-sub {-box {2 0.06 0.4} -color goldenrod}}
shape_set floor -desc {-sub {-box {3.2 0.1 1.6} -color burlywood}}
shape_set wall -desc {-sub {-box {0.1 2.4 1.6} -color lightsteelblue}}
body floor floor -fixed 1 -init_pos {1.4 -0.05 0}
body wall wall -fixed 1 -init_pos {-0.05 1.1 0}
# Along the ladder upwards: (-cos a, sin a); its lower side is 0.03 m off the middle line.
set x [expr {cos($a) + 0.03*sin($a)}]
set y [expr {sin($a) + 0.03*cos($a)}]
body ladder ladder -mass 10 -restitution 0 -init_pos [list $x $y 0] -init_rot [list 0 0 [expr {acos(-1) - $a}]]
force -body ladder -gravitational {0 -9.81 0}
contact foot -body1 ladder -body2 floor
contact head -body1 ladder -body2 wall

plot forces -title "What floor and wall bear" -values {foot.fy head.fx} -labels {floor wall}
view side -rot {0.17 -0.28 -0.02}
