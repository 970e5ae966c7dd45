simulator -start 0 -finish 4 -collisions 0
shape_set block -desc {-sub {-box {1 1 1}}}
body block block -mass 2 -init_dpos {3 0 0}
body floor block -fixed 1 -init_pos {0 -2 0}
force -body block -x {-4 * sign(block.dx)}
