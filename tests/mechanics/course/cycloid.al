# A wheel rolls evenly, and a point of its rim goes along a cycloid: it stands still where it touches the ground.
simulator -finish 2.5
shape_set wheel -desc {-sub {-rot {1.5708 0 0} -cylinder {0.3 0.1}}}
shape_set ground -desc {-sub {-plane}}
body road ground -fixed 1 -friction 0.5
body wheel wheel -mass 2 -restitution 0 -friction 0.5 -init_pos {0 0.3 0} -init_dpos {1.5 0 0} -init_drot {0 0 -5}
force -body wheel -gravitational {0 -9.81 0}
