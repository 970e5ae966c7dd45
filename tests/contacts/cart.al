# zero: b.y-0.3
# zero: c.y-0.1
simulator -finish 2
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0 
shape_set cart -desc {-sub {-box {8 0.2 1}}}
shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}
body c cart -init_pos {0 0.1 0} -mass 3 -friction 0.3 -restitution 0
body b block -init_pos {0 0.3 0} -init_dpos {4 0 0} -mass 1 -friction 0.3 -restitution 0
force -body b -gravitational {0 -9.81 0}
force -body c -gravitational {0 -9.81 0}
