# A crank of 0.05 m at 20 rad/s moves a piston by a massless rod of 0.12 m (closed form).
# zero: hypot(piston.x - crank.px(0.05,0,0), piston.y - crank.py(0.05,0,0)) - 0.12
# zero: piston.y
# zero: crank.x
simulator -finish 0.5
shape_set crank -desc {-sub {-box {0.12 0.02 0.02}}}
shape_set piston -desc {-sub {-box {0.04 0.04 0.04}}}
body crank crank -init_drot {0 0 20}
body piston piston -mass 2 -init_pos {0.17 0 0}
joint pivot -type hinge -body1 crank -speed 20
joint guide -type slider -body1 piston -axis {1 0 0}
joint rod -type distance -body1 crank -offset1 {0.05 0 0} -body2 piston
