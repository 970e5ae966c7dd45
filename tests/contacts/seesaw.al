# zero: plank.y-0.5
simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set plank -desc {-sub {-box {3 0.06 0.4}}}
shape_set box -desc {-sub {-box {0.3 0.3 0.3}}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5
body plank plank -mass 10 -restitution 0 -friction 0.5 -init_pos {0 0.5 0} -init_rot {0 0 0}
joint pivot -type hinge -body1 plank
body left box -mass 5 -restitution 0 -friction 0.5 -init_pos {-1.2 0.6799999999999999 0} -init_rot {0 0 0}
body right box -mass 8 -restitution 0 -friction 0.5 -init_pos {1.2 0.6799999999999999 0} -init_rot {0 0 0}
force -body plank -gravitational {0 -9.81 0}
force -body left -gravitational {0 -9.81 0}
force -body right -gravitational {0 -9.81 0}
