# A log rolls down a wedge of 1 : 2 on ice, and the wedge runs back.
simulator -finish 0.5
shape_set ground -desc {-sub {-plane}}
shape_set wedge -desc {-sub {-points {{0 0 -0.3} {2 0 -0.3} {0 1 -0.3} {0 0 0.3} {2 0 0.3} {0 1 0.3}}}}
shape_set log -desc {-sub {-rot {1.5708 0 0} -cylinder {0.1 0.4}}}
set a [expr {atan2(1, 2)}]
body ice ground -fixed 1
body wedge wedge -mass 3 -friction 0.6 -restitution 0
body log log -mass 1 -friction 0.6 -restitution 0 -init_pos [list [expr {0.2 + 0.1*sin($a)}] [expr {0.9 + 0.1*cos($a)}] 0]
foreach b {wedge log} {force -body $b -gravitational {0 -9.81 0}}
