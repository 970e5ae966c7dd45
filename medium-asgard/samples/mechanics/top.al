# A top spins on a table: friction holds its tip, and its axis goes round and nods, as fast as for a top on
# a fixed point. (Own integration of Euler's equations about the tip.)

parameter spin -value 200 -min 150 -max 400 -label "spin" -unit rad/s
simulator -finish 1

set a 0.2 ;# how it leans at first
shape_set top -desc {-sub {-rot {3.141592653589793 0 0} -cone {0.06 0.1} -color crimson}
    -sub {-pos {0 0.056 0} -cylinder {0.06 0.012} -color gold} -sub {-pos {0 0.092 0} -cylinder {0.008 0.06} -color gold}
    -sub {-pos {0.04 0.066 0} -cylinder {0.01 0.008} -color white}}
shape_set table -desc {-sub {-cylinder {0.4 0.04} -color saddlebrown}}
body table table -fixed 1 -friction 0.6 -init_pos {0 -0.02 0}
body top top -mass 0.3 -inertia {0.0004 0.0003 0.0004} -center {0 0.02 0} -restitution 0 -friction 0.6 \
    -init_pos [list [expr {-0.05*sin($a)}] [expr {0.05*cos($a)}] 0] -init_rot [list 0 0 $a] \
    -init_drot [list [expr {-$spin*sin($a)}] [expr {$spin*cos($a)}] 0]
force -body top -gravitational {0 -9.81 0}

plot axis -title "Way of the axis" -values {top.x top.z} -labels {x z}
view corner -rot {0.37 -0.2 -0.04}
