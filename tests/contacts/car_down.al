# zero: -0.19866933079506122*w0.x+0.9800665778412416*w0.y-0.1
# zero: -0.19866933079506122*w1.x+0.9800665778412416*w1.y-0.1
# zero: -0.19866933079506122*w2.x+0.9800665778412416*w2.y-0.1
# zero: -0.19866933079506122*w3.x+0.9800665778412416*w3.y-0.1
simulator -finish 1
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0.09933466539753061 -0.4900332889206208 0} -init_rot {0.9950041652780258 0.0 0.0 0.09983341664682815} -friction 1
shape_set chassis -desc {-sub {-box {2 0.1 1}}}
body b chassis -init_pos {-0.03973386615901225 0.19601331556824833 0} -init_rot {0.9950041652780258 0.0 0.0 0.09983341664682815} -mass 10
force -body b -gravitational {0 -9.81 0}
body w0 ball -init_pos {-0.7059135375683753 -0.04106187377241867 -0.6} -mass 1 -restitution 0 -friction 1
joint jw0 -type hinge -body1 w0 -offset1 {0 0 0} -body2 b
force -body w0 -gravitational {0 -9.81 0}
body w1 ball -init_pos {-0.7059135375683753 -0.04106187377241867 0.6} -mass 1 -restitution 0 -friction 1
joint jw1 -type hinge -body1 w1 -offset1 {0 0 0} -body2 b
force -body w1 -gravitational {0 -9.81 0}
body w2 ball -init_pos {0.666179671409363 0.23707518934066701 -0.6} -mass 1 -restitution 0 -friction 1
joint jw2 -type hinge -body1 w2 -offset1 {0 0 0} -body2 b
force -body w2 -gravitational {0 -9.81 0}
body w3 ball -init_pos {0.666179671409363 0.23707518934066701 0.6} -mass 1 -restitution 0 -friction 1
joint jw3 -type hinge -body1 w3 -offset1 {0 0 0} -body2 b
force -body w3 -gravitational {0 -9.81 0}
