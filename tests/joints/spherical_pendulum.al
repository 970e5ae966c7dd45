# A ball on a massless rod of 1 m (own integration of three coordinates).
# zero: hypot(ball.x, ball.y, ball.z) - 1
simulator -finish 6
shape_set ball -desc {-sub {-sphere 0.1}}
body ball ball -mass 3 -init_pos {0.8 -0.6 0} -init_dpos {0 0 1.7} -init_drot {1 2 3}
force -body ball -gravitational {0 -9.81 0}
joint rod -type distance -body1 ball -offset2 {0 0 0}
