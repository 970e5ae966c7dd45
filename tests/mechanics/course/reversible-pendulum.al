# A rod hangs 0.5 m from its middle, its twin 1/6 m: Kater's pendulum. They swing alike, for 0.5 times 1/6 is the square of the radius of gyration.
simulator -finish 4
shape_set rod -desc {-sub {-box {0.02 1 0.02}}}
set a 0.8
foreach {name d x} {far 0.5 0 near 0.16666666666666666 2} {
    body $name rod -mass 1 -inertia {0.08333333333333333 0.001 0.08333333333333333} -init_rot [list 0 0 $a] \
        -init_pos [list [expr {$x + $d*sin($a)}] [expr {-$d*cos($a)}] 0]
    joint knife_$name -type hinge -body1 $name -offset1 [list 0 $d 0] -from $a
    force -body $name -gravitational {0 -9.81 0}
}
