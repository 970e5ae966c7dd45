simulator -finish 3.0
shape_set ball -desc {-sub {-sphere 0.05} -sub {-pos {0 0.25 0} -cylinder {0.004 0.5}}}
body b0 ball -init_pos {-0.2823212366975177 -0.41266780745483916 0} -init_rot {0 0 -0.6}
joint h0 -type hinge -body1 b0 -offset1 {0 0.5 0}
body b1 ball -init_pos {0.1 -0.5 0} -init_rot {0 0 0}
joint h1 -type hinge -body1 b1 -offset1 {0 0.5 0}
body b2 ball -init_pos {0.2 -0.5 0} -init_rot {0 0 0}
joint h2 -type hinge -body1 b2 -offset1 {0 0.5 0}
body b3 ball -init_pos {0.30000000000000004 -0.5 0} -init_rot {0 0 0}
joint h3 -type hinge -body1 b3 -offset1 {0 0.5 0}
body b4 ball -init_pos {0.4 -0.5 0} -init_rot {0 0 0}
joint h4 -type hinge -body1 b4 -offset1 {0 0.5 0}
force -body b0 -gravitational {0 -9.81 0}
force -body b1 -gravitational {0 -9.81 0}
force -body b2 -gravitational {0 -9.81 0}
force -body b3 -gravitational {0 -9.81 0}
force -body b4 -gravitational {0 -9.81 0}
