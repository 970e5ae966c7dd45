# zero: b.x^2+b.y^2-0.56
# zero: b.z
simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set bowl -desc {-sub {-bowl {1 1.1}}}
shape_set hoop -desc {-sub {-rot {1.5707963267948966 0 0} -tube {1 1.1 0.6}}}
shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}
shape_set rod -desc {-sub {-rot {0 0 1.5707963267948966} -capsule {0.1 1}}}
body still bowl -fixed 1
body b rod -init_pos {0.35876922158529834 -0.6567226550402226 0} -init_rot {0 0 0.5} -restitution 0
force -body b -gravitational {0 -9.81 0}
