# A belt between two wheels; the side that pulls changes (closed form).
# zero: 0.1*a.wz-0.2*b.wz
simulator -finish 6 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body a disc -mass 1 -inertia {0.02 0.02 0.02}
body b disc -mass 1 -inertia {0.08 0.08 0.08} -init_pos {1 0 0}
joint ha -type hinge -body1 a -axis {0 0 1} -motor {0.1*cos(t)}
joint hb -type hinge -body1 b -axis {0 0 1}
rope r -points {{a {0 0 0} 0.1} {b {0 0 0} 0.2}} -closed 1
