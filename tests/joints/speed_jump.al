# A drive whose speed jumps when a free body passes a place (closed form).
# zero: a.px(-0.5,0,0)
simulator -finish 2 -collisions 0
shape_set rod -desc {-sub {-box {1 0.1 0.1}}}
body a rod -mass 1 -init_pos {0.5 0 0}
body b rod -mass 1 -init_pos {0 3 0} -init_dpos {1 0 0}
force -body a -gravitational {0 -9.81 0}
joint pin -type hinge -body1 a -offset1 {-0.5 0 0} -speed {b.x > 0.7 ? 1 : 0}
body c rod -mass 1 -init_pos {0.5 -3 0}
force -body c -gravitational {0 -9.81 0}
joint swings -type hinge -body1 c -offset1 {-0.5 0 0}
