# Two rafters lean on each other and a tie holds their feet together, one foot on rollers. 1000 N on the ridge: 707 N in each rafter, 500 N in the tie.
simulator -finish 10
shape_set rafter -desc {-sub {-box {1.4142135623730951 0.1 0.1}}}
shape_set foot -desc {-sub {-box {0.1 0.1 0.1}}}
body left rafter -mass 1 -init_pos {-0.5 0.5 0} -init_rot {0 0 0.78539816339744831}
body right rafter -mass 1 -init_pos {0.5 0.5 0} -init_rot {0 0 -0.78539816339744831}
body foot foot -mass 1 -init_pos {1 0 0}
joint wall -type hinge -body1 left -offset1 {-0.70710678118654757 0 0}
joint ridge -type hinge -body1 right -offset1 {-0.70710678118654757 0 0} -body2 left
joint heel -type hinge -body1 right -offset1 {0.70710678118654757 0 0} -body2 foot
joint rollers -type slider -body1 foot -axis {1 0 0}
joint tie -type distance -body1 foot -offset2 {-1 0 0}
force -body left -offset {0.70710678118654757 0 0} -y -1000
