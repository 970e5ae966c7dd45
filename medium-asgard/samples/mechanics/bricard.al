# Bricard's linkage: six hinges in a ring of five rods and the ground. By the count of conditions it could
# not move, and it does. From rest it swings over and comes to rest after 2.49585575684436 s, then back.

simulator -finish 5

shape_set along_x -desc {-sub {-box {1 0.1 0.1}}} 
shape_set along_y -desc {-sub {-box {0.1 1 0.1}}}
shape_set along_z -desc {-sub {-box {0.1 0.1 1}}}
body a along_x -mass 1 -ct 1 -init_pos {0.5 0 0} -color firebrick
body b along_y -mass 1 -ct 1 -init_pos {1 -0.5 0} -color darkorange
body c along_z -mass 1 -ct 1 -init_pos {1 -1 0.5} -color gold
body d along_x -mass 1 -ct 1 -init_pos {0.5 -1 1} -color seagreen
body e along_y -mass 1 -ct 1 -init_pos {0 -0.5 1} -color royalblue
foreach rod {a b c d e} {force -body $rod -gravitational {0 -9.81 0}}
joint p0 -type hinge -body1 a -offset1 {-0.5 0 0} -axis {0 1 0}
joint p1 -type hinge -body1 a -offset1 {0.5 0 0} -body2 b -offset2 {0 0.5 0} -axis {0 0 1}
joint p2 -type hinge -body1 b -offset1 {0 -0.5 0} -body2 c -offset2 {0 0 -0.5} -axis {1 0 0}
joint p3 -type hinge -body1 c -offset1 {0 0 0.5} -body2 d -offset2 {0.5 0 0} -axis {0 1 0}
joint p4 -type hinge -body1 d -offset1 {-0.5 0 0} -body2 e -offset2 {0 -0.5 0} -axis {0 0 1}
joint p5 -type hinge -body1 e -offset1 {0 0.5 0} -axis {1 0 0}

plot angles -title "Angles of the hinges" -values {p0.q p1.q p2.q} -labels {p0 p1 p2}
view corner -rot {0.33 -0.62 -0.11}
