# zero: -0.5646424733950354*b.x+0.8253356149096783*b.y-0.1
simulator -finish 2
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}
body ground floor -fixed 1 -init_pos {0.2823212366975177 -0.41266780745483916 0} -init_rot {0.955336489125606 0 0 0.29552020666133955} -friction 0.1
body b ball -init_pos {-0.05646424733950354 0.08253356149096784 0} -init_rot {0.955336489125606 0 0 0.29552020666133955} -mass 1 -restitution 0 -friction 0.1 -init_dpos {0.0 0.0 0}
force -body b -gravitational {0 -9.81 0}
