# zero: b.x^2+b.y^2+b.z^2-0.81
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set bowl -desc {-sub {-bowl {1 1.1}}}
shape_set hoop -desc {-sub {-rot {1.5707963267948966 0 0} -tube {1 1.1 0.6}}}
shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}
body still bowl -fixed 1 -friction 0.9
body b ball -init_pos {0.7573238863271069 -0.4862720752813258 0.0} -mass 1 -restitution 0 -friction 0.9 -init_dpos {0.0 0.0 0} -init_drot {0 0 -0.0}
force -body b -gravitational {0 -9.81 0}
