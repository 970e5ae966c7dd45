# A motor holds one rod where a cam on the other one's hinge says, which has a slope near an angle of -1 alone (own integration).
# zero: hypot(a.px(-0.5,0,0), a.py(-0.5,0,0))
# zero: hypot(a.px(0.5,0,0) - b.px(-0.5,0,0), a.py(0.5,0,0) - b.py(-0.5,0,0))
# zero: j1.q - 0.04*exp(-((j2.q+1)/0.15)^2)
simulator -finish 1
shape_set rod -desc {-sub {-box {1 0.1 0.1}}}
body a rod -mass 1 -init_pos {0.5 0 0}
body b rod -mass 1 -init_pos {1.5 0 0}
joint j1 -type hinge -body1 a -offset1 {-0.5 0 0} -position {0.04*exp(-((j2.q+1)/0.15)^2)}
joint j2 -type hinge -body1 b -offset1 {-0.5 0 0} -body2 a -offset2 {0.5 0 0}
foreach body {a b} {force -body $body -gravitational {0 -9.81 0}}
