# Galileo's pendulum: a ball swings on a string of 1 m until the string meets a peg. From there it goes
# round the peg, and rises as high as it was, but for what winds up; then it swings back and lifts off.

parameter peg_height -value -0.5 -min -0.7 -max -0.35 -label "height of the peg" -unit m
simulator -finish 4

set quarter [expr {acos(-1)/2}]
shape_set ball -desc {-sub {-sphere 0.05}} -color crimson -shininess 0.8
shape_set peg -desc "-sub {-rot {$quarter 0 0} -cylinder {0.01 0.12} -color gold}"
shape_set nail -desc "-sub {-rot {$quarter 0 0} -cylinder {0.012 0.12} -color dimgray}"
shape_set board -desc {-sub {-box {1.7 1.3 0.03}}} -color lightsteelblue
body board board -fixed 1 -ct 1 -init_pos {0 -0.5 -0.09}
body nail nail -fixed 1 -ct 1 -init_pos {0 0 -0.02}
body peg peg -fixed 1 -ct 1 -init_pos [list 0.01 $peg_height -0.02]
body ball ball -mass 0.5 -ct 1 -init_pos {-0.6 -0.8 0}
# The string passes the peg on its left: a radius under 0. It is as long as the way from the nail to the ball.
rope string -points {{0 0 0} {peg {0 0 0.02} -0.01} {ball}} -length 1
force -body ball -gravitational {0 -9.81 0}

plot height -title "Height over the lowest point" -values {ball.y+1} -labels {m}
view front -rot {0.06 -0.1 0}
