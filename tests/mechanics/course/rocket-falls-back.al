# A shell leaves the earth straight up with 8 km/s: the pull grows less with height, so it comes far higher than v^2 / (2 g).
simulator -finish 4000
shape_set shell -desc {-sub {-sphere 1}}
body shell shell -mass 1 -init_pos {0 6371000 0} -init_dpos {0 8000 0}
force -body shell -y {-9.81*6371000^2/shell.y^2}
