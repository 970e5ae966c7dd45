# zero: man.x
simulator -finish 6
shape_set cabin -desc {-sub {-pos {0 -0.05 0} -box {2 0.1 2}}}
shape_set man -desc {-sub {-box {0.5 1.8 0.4}}}
body cabin cabin -mass 400
joint shaft -type slider -body1 cabin -axis {0 1 0} -speed {t < 2 ? t : t < 4 ? 2 : 6 - t}
body man man -mass 80 -restitution 0 -init_pos {0 0.9 0}
contact feet -body1 man -body2 cabin
force -body man -gravitational {0 -9.81 0}
force -body cabin -gravitational {0 -9.81 0}
