# zero: -0.29552020666133955*b.x+0.955336489125606*b.y-0.1
simulator -finish 3
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}
body ground floor -fixed 1 -init_pos {0.14776010333066977 -0.477668244562803 0} -init_rot {0.9887710779360422 0 0 0.14943813247359922} -friction 0.4
body b block -init_pos {-0.029552020666133955 0.09553364891256061 0} -init_rot {0.9887710779360422 0 0 0.14943813247359922} -mass 1 -restitution 0 -friction 0.4 -init_dpos {4.77668244562803 1.4776010333066978 0}
force -body b -gravitational {0 -9.81 0}
contact on -body1 b -body2 ground
