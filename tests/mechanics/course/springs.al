# Three weights of 1 kg are hung on springs of 100 N/m and let go: one swings for ever, one dies away, one creeps to its place (critical damping).
simulator -finish 4
shape_set weight -desc {-sub {-box {0.1 0.1 0.1}}}
foreach {name x c} {free 0 0 damped 0.5 2 critical 1 20} {
    body $name weight -mass 1 -init_pos [list $x -0.5 0]
    spring spring_$name -body1 $name -x $x -y 0 -z 0 -stiffness 100 -rest 0.5 -damping $c
    force -body $name -gravitational {0 -9.81 0}
}
