# Two balls on a massless rod are thrown and turn (closed form).
# zero: hypot(a.x - b.x, a.y - b.y, a.z - b.z) - 1
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
body a ball -mass 1 -init_pos [list [expr {-2/3.0}] 0 0] -init_dpos {1 2 0.5}
body b ball -mass 2 -init_pos [list [expr {1/3.0}] 0 0] -init_dpos {1 5 0.5}
force -body a -gravitational {0 -9.81 0}
force -body b -gravitational {0 -9.81 0}
joint rod -type distance -body1 a -body2 b
