# A block of 2 kg on a table is drawn by a weight of 1 kg over its edge, until that lies on the floor; then
# friction alone stops the block. With mu = 0.3: a = (m - mu M) g / (M + m) = 1.308 m/s^2, and mu g behind.

parameter friction -value 0.3 -min 0.1 -max 0.45 -label "friction on the table"
simulator -finish 2

set quarter [expr {acos(-1)/2}]
shape_set table -desc {-sub {-box {2 0.06 0.8} -color saddlebrown} -sub {-pos {-0.9 -0.49 0} -box {0.06 0.92 0.7} -color peru}
    -sub {-pos {0.8 -0.49 0} -box {0.06 0.92 0.7} -color peru}}
shape_set floor -desc {-sub {-box {3.2 0.1 1.6} -color burlywood}}
shape_set block -desc {-sub {-box {0.3 0.2 0.3} -color steelblue}}
shape_set weight -desc {-sub {-cylinder {0.08 0.2} -color goldenrod}}
shape_set pulley -desc "-sub {-rot {$quarter 0 0} -cylinder {0.09 0.04} -color gray}"
body floor floor -fixed 1 -init_pos {0 -0.05 0}
body table table -fixed 1 -init_pos {0 0.97 0} -friction $friction
body pulley pulley -fixed 1 -ct 1 -init_pos {1.11 1.01 0}
body block block -mass 2 -friction $friction -restitution 0 -init_pos {-0.7 1.1 0}
body weight weight -mass 1 -restitution 0 -ct 1 -init_pos {1.2 0.6 0}
rope line -points {{block {0.15 0 0}} {1.2 1.1 0} {weight {0 0.1 0}}}
foreach body {block weight} {force -body $body -gravitational {0 -9.81 0}}

plot motion -title "Speed of the block, and tension of the rope" -values {block.dx line.tension} -labels {m/s N}
view front -rot {0.14 -0.15 -0.01}
