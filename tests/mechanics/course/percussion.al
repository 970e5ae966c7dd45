# A ball strikes a rod that hangs from a hinge, at 2/3 of its length: the hinge feels no blow (the centre of percussion).
simulator -finish 0.8
shape_set rod -desc {-sub {-box {0.04 0.9 0.04}}}
shape_set ball -desc {-sub {-sphere 0.05}}
body rod rod -mass 2 -inertia {0.135 0.001 0.135} -restitution 0.6 -init_pos {0 -0.45 0}
joint pin -type hinge -body1 rod -offset1 {0 0.45 0}
body ball ball -mass 0.5 -restitution 0.6 -init_pos {-0.47 -0.6 0} -init_dpos {4 0 0}
force -body rod -gravitational {0 -9.81 0}
