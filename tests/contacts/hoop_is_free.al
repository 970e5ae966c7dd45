# zero: b.z
simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set bowl -desc {-sub {-bowl {1 1.1}}}
shape_set hoop -desc {-sub {-rot {1.5707963267948966 0 0} -tube {1 1.1 0.6}}}
shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}
body hoop hoop -mass 3
body b ball -init_dpos {4 0 0} -mass 1
