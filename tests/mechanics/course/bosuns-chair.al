# A man of 70 kg sits on a board of 10 kg and holds himself by the rope that goes from it over a hook: he needs half of both weights.
simulator -finish 10
shape_set man -desc {-sub {-box {0.4 0.8 0.4}}}
shape_set board -desc {-sub {-box {0.5 0.1 0.5}}}
body board board -mass 10 -restitution 0
body man man -mass 70 -restitution 0 -init_pos {0 0.45 0}
contact seat -body1 man -body2 board
rope line -points {{board} {0 4 0} {man {0 0.2 0}}}
foreach b {board man} {force -body $b -gravitational {0 -9.81 0}}
