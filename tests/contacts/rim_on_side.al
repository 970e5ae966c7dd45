simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set log -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.2 1}}}
body log log -fixed 1 -init_pos {0 -0.2 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.016325287059620427 0.1794286949556051 0.0062312461794897} -init_rot {0.0 -0.7 -0.7} -init_dpos {0.0 0.03790905237795906 0.0} -init_drot {2.3 1.9 3.2}
force -body b -gravitational {0 -9.81 0}
