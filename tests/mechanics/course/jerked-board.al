# Crates stand on boards on ice (friction 0.3). A pull of 10 N takes board and crate along; 30 N draw the board away below the crate.
simulator -finish 0.5
shape_set ground -desc {-sub {-plane}}
shape_set board -desc {-sub {-box {3 0.1 0.4}}}
shape_set crate -desc {-sub {-box {0.2 0.2 0.2}}}
body ice ground -fixed 1
foreach {name z pull} {gentle 0 10 jerk 1 30} {
    body board_$name board -mass 4 -friction 0.3 -restitution 0 -init_pos [list 0 0.05 $z]
    body crate_$name crate -mass 1 -friction 0.3 -restitution 0 -init_pos [list 0 0.2 $z]
    force -body board_$name -x $pull
    force -body board_$name -gravitational {0 -9.81 0}
    force -body crate_$name -gravitational {0 -9.81 0}
}
