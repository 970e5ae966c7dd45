simulator -finish 1
shape_set floor -desc {-sub {-box {8 0.2 2}}}
shape_set wall -desc {-sub {-box {0.2 4 2}}}
shape_set ladder -desc {-sub {-box {2 0.04 0.4}}}
body floor floor -fixed 1 -init_pos {3 -0.1 0}
body wall wall -fixed 1 -init_pos {-0.1 2 0}
body ladder ladder -mass 10 -restitution 0 -init_pos {0.7212489168102786 0.7212489168102785 0} -init_rot {0 0 2.356194490192345}
force -body ladder -gravitational {0 -9.81 0}
