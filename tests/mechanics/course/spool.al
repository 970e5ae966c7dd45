# A thread leaves a spool at the bottom of its core and goes level to a peg, over it a weight hangs: the spool rolls towards the peg and winds the thread up.
simulator -finish 1.5
shape_set spool -desc {-sub {-rot {1.5708 0 0} -cylinder {0.3 0.1}}}
shape_set weight -desc {-sub {-box {0.1 0.1 0.1}}}
shape_set ground -desc {-sub {-plane}}
body floor ground -fixed 1 -friction 0.6 -ct 1
body spool spool -mass 2 -inertia {0.06 0.06 0.09} -friction 0.6 -restitution 0 -init_pos {0 0.3 0}
body weight weight -mass 0.5 -init_pos {3 -0.5 0} -ct 1
rope thread -points {{spool {0 0 0} 0.1} {3 0.2 0} {weight}}
foreach b {spool weight} {force -body $b -gravitational {0 -9.81 0}}
