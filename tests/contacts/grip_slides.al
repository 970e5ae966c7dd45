# zero: jaw1.y-1
simulator -finish 200
shape_set cube -desc {-sub {-box {0.2 0.2 0.2}}}
body box cube -mass 2 -init_pos {0 1 0} -friction 0.5 -restitution 0
body jaw1 cube -mass 1 -init_pos {-0.2 1 0} -friction 0.5 -restitution 0
joint rail1 -type slider -body1 jaw1 -axis {1 0 0}
force -body jaw1 -x 19.61999998038
body jaw2 cube -mass 1 -init_pos {0.2 1 0} -friction 0.5 -restitution 0
joint rail2 -type slider -body1 jaw2 -axis {1 0 0}
force -body jaw2 -x -19.61999998038
force -body box -gravitational {0 -9.81 0}
