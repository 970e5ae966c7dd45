# Atwood's machines: over a wheel with inertia, over points without friction, with a block and tackle (closed forms).
# zero: e.x-5
# zero: through.length-4
# zero: over.length-4-0.2*pi
simulator -finish 0.9 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body a ball -mass 2 -init_pos {-0.2 -1 0}
body b ball -mass 1 -init_pos {0.2 -3 0}
body w disc -mass 1 -inertia {0.02 0.02 0.02}
joint axle -type hinge -body1 w -axis {0 0 1}
rope over -points {{a {0 0 0}} {w {0 0 0} 0.2} {b {0 0 0}}}
body c ball -mass 2 -init_pos {2 -1 0}
body d ball -mass 1.5 -init_pos {3 -2 0}
rope through -points {{c {0 0 0}} {2 0 0} {3 0 0} {d {0 0 0}}}
body e disc -mass 3 -inertia {0.01 0.01 0.01} -init_pos {5 -2 0}
body f ball -mass 2 -init_pos {5.3 -1 0}
body guide disc -mass 1 -inertia {0.03 0.03 0.03} -init_pos {5.2 0 0}
joint pivot -type hinge -body1 guide -axis {0 0 1}
rope hoist -points {{4.9 0 0} {e {0 0 0} 0.1} {guide {0 0 0} 0.1} {f {0 0 0}}}
foreach it {a b c d e f} {
    force -body $it -gravitational {0 -9.81 0}
}
