# Rest from the start, rest after a fall, a trajectory, a link, and nothing at all.
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.5}}
shape_set slab -desc {-sub {-box {20 1 20}}}
body floor slab -init_pos {0 -0.5 0} -fixed 1
body still ball -init_pos {0 0.5 0} -restitution 0
body dropped ball -init_pos {3 2 0} -restitution 0.5
foreach b {still dropped} {force -body $b -gravitational {0 -9.81 0}}
body cart ball -init_pos {-4 5 0}
trajectory path -points {{0 -4 5 0} {1 -3 5 0} {2 -3 6 0}}
constrain cart -pos path
body hung ball -init_pos {-7 5 0}
link -body1 hung -x -7 -y 6 -z 0 -tightness 10
force -body hung -x {-0.1*hung.dx}
body free ball -init_pos {8 5 0} -init_dpos {0 1 0}
