# A trebuchet: 60 kg at the short end of the arm sink, the long end swings up and draws a stone of 0.5 kg in
# a sling of 1.1 m, over the ground at first and then round. The sling lets go when the stone flies at 40
# degrees; from there it is on a parabola. (Own integration of arm, weight and stone.)

parameter load -value 60 -min 30 -max 120 -label "counterweight" -unit kg
simulator -finish 1.4

shape_set arm -desc {-sub {-pos {-0.5 0 0} -box {2 0.08 0.06} -color peru}}
shape_set weight -desc {-sub {-pos {0 -0.32 0} -box {0.34 0.28 0.3} -color dimgray} -sub {-pos {0 -0.09 0} -box {0.04 0.18 0.04} -color gray}}
shape_set stone -desc {-sub {-sphere 0.06 -color slategray}}
shape_set frame -desc {-sub {-pos {0 0.6 0.2} -box {0.08 1.3 0.06} -color saddlebrown} -sub {-pos {0 0.6 -0.2} -box {0.08 1.3 0.06} -color saddlebrown}
    -sub {-pos {0 0.02 0.2} -box {1.2 0.06 0.06} -color saddlebrown} -sub {-pos {0 0.02 -0.2} -box {1.2 0.06 0.06} -color saddlebrown}}
shape_set ground -desc {-sub {-box {12 0.1 3} -color darkseagreen}}
body ground ground -fixed 1 -init_pos {2.5 -0.05 0}
body frame frame -fixed 1 -ct 1

# The arm slopes down to the left, where its long end (1.5 m from the axle) is near the ground.
set s 0.74
set c [expr {sqrt(1 - $s*$s)}]
set x [expr {-1.5*$c}]
set y [expr {1.2 - 1.5*$s}]
body arm arm -ct 1 -mass 4 -inertia {0.01 1.4 1.4} -center {-0.5 0 0} -init_pos {0 1.2 0} -init_rot [list 0 0 [expr {asin($s)}]]
body weight weight -ct 1 -mass $load -inertia {0.9 0.9 0.9} -center {0 -0.3 0} -init_pos [list [expr {0.5*$c}] [expr {1.2 + 0.5*$s}] 0]
body stone stone -ct 1 -mass 0.5 -restitution 0 -init_pos [list [expr {$x + sqrt(1.21 - ($y - 0.06)**2)}] 0.06 0]
joint axle -type hinge -body1 arm -offset1 {0 0 0}
joint hanger -type hinge -body1 weight -offset1 {0 0 0} -body2 arm -offset2 {0.5 0 0}
rope sling -points {{arm {-1.5 0 0}} {stone {0 0 0}}} -release {stone.y > 1.5 && stone.dx > 0 && stone.dy < stone.dx*0.8390996311772799}
foreach name {arm weight stone} {force -body $name -gravitational {0 -9.81 0}}
view side -rot {0.04 -0.05 0}
