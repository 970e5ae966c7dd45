# A small ball falls on top of a big one: the big one comes back from the floor and throws the small one far higher than it fell from.
simulator -finish 1
shape_set big -desc {-sub {-sphere 0.1}}
shape_set small -desc {-sub {-sphere 0.03}}
shape_set ground -desc {-sub {-plane}}
body floor ground -fixed 1
body big big -mass 0.5 -init_pos {0 1.1 0}
body small small -mass 0.05 -init_pos {0 1.23 0}
foreach b {big small} {force -body $b -gravitational {0 -9.81 0}}
