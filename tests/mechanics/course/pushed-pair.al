# 10 N push a block of 2 kg, which pushes one of 3 kg: both gain 2 m/s^2, and 6 N act between them.
simulator -finish 2
shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}
shape_set ground -desc {-sub {-plane}}
body ice ground -fixed 1
body one block -mass 2 -restitution 0 -init_pos {0 0.1 0}
body two block -mass 3 -restitution 0 -init_pos {0.2 0.1 0}
contact between -body1 one -body2 two
force -body one -x 10
foreach b {one two} {force -body $b -gravitational {0 -9.81 0}}
