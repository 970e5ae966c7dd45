# Two brakes on one motion, which a rod couples, begin to slip together (closed form).
# zero: b.x-a.x-1
simulator -finish 2.1 -collisions 0
shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}
body a box -mass 1
body b box -mass 1 -init_pos {1 0 0}
force -body a -x {3*t} -y 0 -z 0
joint s -type slider -body1 a -axis {1 0 0} -friction 1
joint u -type slider -body1 b -axis {1 0 0} -friction 1
joint d -type distance -body1 a -body2 b
