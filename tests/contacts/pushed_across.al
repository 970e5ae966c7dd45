# zero: b.y-0.05
simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.3 
shape_set box -desc {-sub {-box {0.2 0.1 0.2}}}
body b box -init_pos {0 0.05 0} -mass 1 -friction 0.3 -restitution 0
force -body b -x 2 -z t
force -body b -gravitational {0 -9.81 0}
