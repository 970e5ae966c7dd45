# A wheel rolls down two rails on its thin axle: so slowly that one can count, for its rim turns fast.
simulator -finish 6
shape_set rail -desc {-sub {-box {3 0.04 0.04}}}
shape_set wheel -desc {-sub {-rot {1.5708 0 0} -cylinder {0.15 0.04}} -sub {-pos {0 0 0.1} -rot {1.5708 0 0} -cylinder {0.01 0.16}}
    -sub {-pos {0 0 -0.1} -rot {1.5708 0 0} -cylinder {0.01 0.16}}}
set a 0.1
set down [list 0 0 [expr {-$a}]]
foreach {name z} {near 0.1 far -0.1} {
    body $name rail -fixed 1 -friction 0.5 -init_rot $down -init_pos [list [expr {-0.02*sin($a)}] [expr {-0.02*cos($a)}] $z]
}
body wheel wheel -mass 1 -inertia {0.006 0.006 0.011} -center {0 0 0} -friction 0.5 -restitution 0 -init_rot $down \
    -init_pos [list [expr {-cos($a) + 0.01*sin($a)}] [expr {sin($a) + 0.01*cos($a)}] 0]
force -body wheel -gravitational {0 -9.81 0}
