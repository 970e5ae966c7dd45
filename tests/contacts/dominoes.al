# zero: d0.z
simulator -finish 4
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set slab -desc {-sub {-box {0.2 2 1}}}
body d0 slab -init_pos {0.0 1 0} -friction 0.3 -restitution 0 -init_drot {0 0 -1.6}
body d1 slab -init_pos {1.2 1 0} -friction 0.3 -restitution 0
body d2 slab -init_pos {2.4 1 0} -friction 0.3 -restitution 0
force -body d0 -gravitational {0 -9.81 0}
force -body d1 -gravitational {0 -9.81 0}
force -body d2 -gravitational {0 -9.81 0}
