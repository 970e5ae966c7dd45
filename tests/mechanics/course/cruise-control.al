# A car of 1 t drives up a road that rises by 0.05 rad; the controller gives 800 N for each m/s that are missing to 20: it stays a little behind.
simulator -finish 10
shape_set car -desc {-sub {-box {4 1.4 1.8}}}
set a 0.05
body car car -mass 1000 -init_rot [list 0 0 $a]
joint road -type slider -body1 car -axis {1 0 0} -motor {800*(20 - road.dq)}
force -body car -gravitational {0 -9.81 0}
