# Bricard's mechanism (IFToMM A04): five rods on six hinges, of which one condition is redundant; from rest it swings and returns.
# zero: hypot(a.px(-0.5,0,0), a.py(-0.5,0,0), a.pz(-0.5,0,0))
# zero: hypot(a.px(0.5,0,0) - b.px(0,0.5,0), a.py(0.5,0,0) - b.py(0,0.5,0), a.pz(0.5,0,0) - b.pz(0,0.5,0))
# zero: hypot(c.px(0,0,0.5) - d.px(0.5,0,0), c.py(0,0,0.5) - d.py(0.5,0,0), c.pz(0,0,0.5) - d.pz(0.5,0,0))
# zero: hypot(e.px(0,0.5,0), e.py(0,0.5,0), e.pz(0,0.5,0) - 1)
simulator -finish 5
shape_set alongx -desc {-sub {-box {1 0.1 0.1}}}
shape_set alongy -desc {-sub {-box {0.1 1 0.1}}}
shape_set alongz -desc {-sub {-box {0.1 0.1 1}}}
body a alongx -mass 1 -init_pos {0.5 0 0}
body b alongy -mass 1 -init_pos {1 -0.5 0}
body c alongz -mass 1 -init_pos {1 -1 0.5}
body d alongx -mass 1 -init_pos {0.5 -1 1}
body e alongy -mass 1 -init_pos {0 -0.5 1}
foreach rod {a b c d e} {force -body $rod -gravitational {0 -9.81 0}}
joint p0 -type hinge -body1 a -offset1 {-0.5 0 0} -axis {0 1 0}
joint p1 -type hinge -body1 a -offset1 {0.5 0 0} -body2 b -offset2 {0 0.5 0} -axis {0 0 1}
joint p2 -type hinge -body1 b -offset1 {0 -0.5 0} -body2 c -offset2 {0 0 -0.5} -axis {1 0 0}
joint p3 -type hinge -body1 c -offset1 {0 0 0.5} -body2 d -offset2 {0.5 0 0} -axis {0 1 0}
joint p4 -type hinge -body1 d -offset1 {-0.5 0 0} -body2 e -offset2 {0 -0.5 0} -axis {0 0 1}
joint p5 -type hinge -body1 e -offset1 {0 0.5 0} -axis {1 0 0}
