# A yo-yo swings as it unwinds (own integration).
# zero: y.z
simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body y disc -mass 1 -inertia {0.04 0.04 0.04} -init_pos {0.1 -1 0} -init_dpos {1.5 0 0}
force -body y -gravitational {0 -9.81 0}
rope r -points {{0 0 0} {y {0 0 0} 0.1}}
