# zero: b.y+0.35825756949558396
simulator -finish 0.7
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set bowl -desc {-sub {-bowl {1 1.1}}}
shape_set hoop -desc {-sub {-rot {1.5707963267948966 0 0} -tube {1 1.1 0.6}}}
shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}
shape_set box -desc {-sub {-box {0.6 0.2 0.4}}}
body still pipe -fixed 1 -friction 0.25
body b box -init_pos {0 -0.35825756949558396 0} -init_dpos {2 0 0} -mass 1 -restitution 0 -friction 0.25
force -body b -gravitational {0 -9.81 0}
