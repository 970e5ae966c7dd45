# Two wheels of 20 kg stand before a kerb of 0.1 m; one is drawn at its axle with a little less than it takes to climb, one with a little more.
simulator -finish 0.4
shape_set ground -desc {-sub {-plane}}
shape_set kerb -desc {-sub {-box {1 0.1 1}}}
shape_set wheel -desc {-sub {-rot {1.5708 0 0} -cylinder {0.4 0.1}}}
body road ground -fixed 1 -friction 1
set x [expr {-sqrt(0.16 - 0.09)}]
set just [expr {20*9.81*sqrt(0.16 - 0.09)/0.3}]
foreach {name z part} {stays -1 0.99 climbs 1 1.05} {
    body kerb_$name kerb -fixed 1 -friction 1 -init_pos [list 0.5 0.05 $z]
    body $name wheel -mass 20 -friction 1 -restitution 0 -init_pos [list $x 0.4 $z]
    force -body $name -x [expr {$part*$just}]
    force -body $name -gravitational {0 -9.81 0}
}
