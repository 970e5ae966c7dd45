# A coin rides on a turntable of 2 rad/s, 0.3 m from the middle: friction gives the m w^2 r that keep it on its circle.
simulator -finish 5
shape_set table -desc {-sub {-cylinder {0.5 0.04}}}
shape_set coin -desc {-sub {-cylinder {0.03 0.01}}}
body table table -mass 3 -friction 0.5 -restitution 0
joint axle -type hinge -body1 table -axis {0 1 0} -speed 2
body coin coin -mass 0.02 -friction 0.5 -restitution 0 -init_pos {0.3 0.025 0} -init_dpos {0 0 -0.6} -init_drot {0 2 0}
contact hold -body1 coin -body2 table
force -body coin -gravitational {0 -9.81 0}
