simulator -start 0 -finish 4
shape_set rod -desc {-sub {-box {2 0.2 0.2}}}
shape_set bob -desc {-sub {-sphere 0.2}}
foreach {name x} {left 0 right 9} {
    body $name rod -mass 3 -init_pos [list [expr {$x + 1}] 0 0]
    force -body $name -gravitational {0 -10 0}
    link -body1 $name -offset1 {-1 0 0} -x $x -y 0 -z 0 -tightness 100
}
