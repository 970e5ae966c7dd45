# The light weight of a double machine of Atwood hits the wheel from below at t = 0.7312, on taut ropes and without loss.
simulator -finish 0.8
shape_set weight -desc {-sub {-box {0.1 0.1 0.1}}}
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.1 0.02}}}
body top wheel -mass 0.2 -init_pos {0 2 0}
joint axle -type hinge -body1 top
body m1 weight -mass 3 -init_pos {-0.1 1 0}
body low wheel -mass 0.2 -init_pos {0.1 1.2 0}
body m2 weight -mass 1 -init_pos {0 0.2 0}
body m3 weight -mass 2 -init_pos {0.2 0.2 0}
rope r1 -points {{m1} {top {0 0 0} 0.1} {low}}
rope r2 -points {{m2} {low {0 0 0} 0.1} {m3}}
foreach b {m1 low m2 m3} {force -body $b -gravitational {0 -9.81 0}}
