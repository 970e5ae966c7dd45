# zero: b.y-0.05
simulator -finish 5.905
shape_set post -desc {-sub {-box {0.1 1 0.4}}}
shape_set plank -desc {-sub {-box {1.4 0.1 0.2}}}
body s1 post -init_pos {-0.5 -0.5 0} -fixed 1 -friction 0.25
body s2 post -init_pos {0.5 -0.5 0} -fixed 1 -friction 0.25
body b plank -init_pos {0 0.05 0} -friction 1 -restitution 0 -mass 1
force -body b -x t
force -body b -gravitational {0 -9.81 0}
