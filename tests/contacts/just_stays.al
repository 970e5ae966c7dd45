# zero: -0.479425538604203*b.x+0.8775825618903728*b.y-0.1
simulator -finish 1000
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}
body ground floor -fixed 1 -init_pos {0.2397127693021015 -0.4387912809451864 0} -init_rot {0.9689124217106447 0 0 0.24740395925452294} -friction 0.546302490390093
body b block -init_pos {-0.0479425538604203 0.08775825618903728 0} -init_rot {0.9689124217106447 0 0 0.24740395925452294} -mass 1 -restitution 0 -friction 0.546302490390093 -init_dpos {0.0 0.0 0}
force -body b -gravitational {0 -9.81 0}
