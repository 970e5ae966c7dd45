# A ball rolls on a turntable of 3 rad/s: it does not fly off but goes round in a circle, with 2/7 of the table's speed.
simulator -finish 8
shape_set table -desc {-sub {-cylinder {3 0.1}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body table table -mass 10 -friction 0.8 -restitution 0
joint axle -type hinge -body1 table -axis {0 1 0} -speed 3
body ball ball -mass 1 -friction 0.8 -restitution 0 -init_pos {0.5 0.15 0} -init_dpos {0.6 0 0} -init_drot {15 0 -6}
force -body ball -gravitational {0 -9.81 0}
