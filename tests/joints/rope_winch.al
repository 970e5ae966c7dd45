# A drum that is turned winds a rope, whose load swings (own integration).
# zero: h.dq-sin(3*t)
simulator -finish 3 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body drum disc -mass 1 -inertia {0.05 0.05 0.05}
joint h -type hinge -body1 drum -axis {0 0 1} -speed {sin(3*t)}
body m ball -mass 3 -init_pos {0.2 -2 0} -init_dpos {1.4 0 0}
force -body m -gravitational {0 -9.81 0}
rope r -points {{drum {0 0 0} -0.2} {m {0 0 0}}}
