# A double machine of Atwood whose wheels lie askew, turned by 1.57082 instead of pi/2: by their shapes, and by their attitudes.
# zero: r1.length-1.8-0.1*pi
# zero: v2.length-2-0.1*pi
simulator -finish 0.7 -collisions 0
shape_set weight -desc {-sub {-box {0.1 0.1 0.1}}}
shape_set wheel -desc {-sub {-rot {1.57082 0 0} -cylinder {0.1 0.02}}}
shape_set lying -desc {-sub {-cylinder {0.1 0.02}}}
body top wheel -mass 0.2 -init_pos {0 2 0}
joint axle -type hinge -body1 top
body m1 weight -mass 3 -init_pos {-0.1 1 0}
body low wheel -mass 0.2 -init_pos {0.1 1.2 0}
body m2 weight -mass 1 -init_pos {0 0.2 0}
body m3 weight -mass 2 -init_pos {0.2 0.2 0}
rope r1 -points {{m1} {top {0 0 0} 0.1} {low}}
rope r2 -points {{m2} {low {0 0 0} 0.1} {m3}}
body high lying -mass 0.2 -init_pos {1 2 0} -init_rot {1.57082 0 0}
joint axis -type hinge -body1 high -axis {0 1 0}
body n1 weight -mass 3 -init_pos {0.9 1 0}
body deep lying -mass 0.2 -init_pos {1.1 1.2 0} -init_rot {1.57082 0 0}
body n2 weight -mass 1 -init_pos {1 0.2 0}
body n3 weight -mass 2 -init_pos {1.2 0.2 0}
rope v1 -points {{n1} {high {0 0 0} 0.1 {0 1 0}} {deep}}
rope v2 -points {{n2} {deep {0 0 0} 0.1 {0 1 0}} {n3}}
foreach b {m1 low m2 m3 n1 deep n2 n3} {force -body $b -gravitational {0 -9.81 0}}
