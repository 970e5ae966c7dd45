# A stone falls through a tunnel along the earth's axis: it is at the other end after 42 minutes, pi sqrt(R / g).
simulator -finish 5070
shape_set stone -desc {-sub {-sphere 1}}
body stone stone -mass 1000 -init_pos {0 6371000 0}
force -body stone -y {-9.81*stone.mass*stone.y/6371000}
