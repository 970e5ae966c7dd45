# One ball is let go, another one is thrown level from the same height at the same instant: both land at once, and bounce at once.
simulator -finish 1.2
shape_set ball -desc {-sub {-sphere 0.05}}
shape_set ground -desc {-sub {-plane}}
body floor ground -fixed 1
body dropped ball -init_pos {0 2 0}
body thrown ball -init_pos {0.3 2 0} -init_dpos {3 0 0}
foreach b {dropped thrown} {force -body $b -gravitational {0 -9.81 0}}
