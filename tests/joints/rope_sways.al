# A bob hangs from a drum that stands, swings along the drum's axis and across it.
simulator -finish 2 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
body drum ball -fixed 1
body b ball -mass 2 -inertia {0.01 0.01 0.01} -init_pos {-0.2 -1 0} -init_dpos {0.3 0 0.5}
rope r -points {{drum {0 0 0} 0.2} {b}}
force -body b -gravitational {0 -9.81 0}
