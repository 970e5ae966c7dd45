# What meshes touches, and need be in no collision group.
# zero: rail.q-0.3*axle.q
# zero: one.q+two.q/2
simulator -finish 3
shape_set rack -desc {-sub {-box {2 0.1 0.1}}}
shape_set pinion -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.3 0.1}}}
shape_set large -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.4 0.1}}}
shape_set small -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.2 0.1}}}
body rack rack -mass 3
body pinion pinion -mass 2 -init_pos {0 0.35 0}
joint rail -type slider -body1 rack -axis {1 0 0}
joint axle -type hinge -body1 pinion -offset1 {0 0 0} -motor {sin(2*t)}
gear mesh -joint1 rail -joint2 axle -ratio 0.3
body large large -mass 3 -init_pos {0 2 0}
body small small -mass 1 -init_pos {0.6 2 0}
joint one -type hinge -body1 large -offset1 {0 0 0} -motor 2
joint two -type hinge -body1 small -offset1 {0 0 0}
gear wheels -joint1 one -joint2 two -ratio -0.5
