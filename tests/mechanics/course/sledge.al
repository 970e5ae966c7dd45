# Two sledges of 10 kg are drawn with 40 N, one level, one at 30 degrees upwards: the second one gains speed faster, for it presses less.
simulator -finish 2
shape_set ground -desc {-sub {-plane}}
shape_set sledge -desc {-sub {-box {1 0.2 0.5}}}
body snow ground -fixed 1 -friction 0.3
foreach {name degrees z} {level 0 0 lifted 30 1} {
    set a [expr {$degrees*acos(-1)/180}]
    body $name sledge -mass 10 -friction 0.3 -restitution 0 -init_pos [list 0 0.1 $z]
    contact under_$name -body1 $name -body2 snow
    force -body $name -x [expr {40*cos($a)}] -y [expr {40*sin($a)}]
    force -body $name -gravitational {0 -9.81 0}
}
