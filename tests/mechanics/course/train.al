# An engine of 4 t draws waggons of 2 t and 1 t with 14 kN: all gain 2 m/s^2, the couplings bear 6 kN and 2 kN.
simulator -finish 5
shape_set waggon -desc {-sub {-box {6 2 2}}}
foreach {name mass x} {engine 4000 0 first 2000 -8 second 1000 -16} {
    body $name waggon -mass $mass -init_pos [list $x 0 0]
    joint rail_$name -type slider -body1 $name -axis {1 0 0}
    force -body $name -gravitational {0 -9.81 0}
}
joint front -type distance -body1 first -offset1 {3 0 0} -body2 engine -offset2 {-3 0 0}
joint rear -type distance -body1 second -offset1 {3 0 0} -body2 first -offset2 {-3 0 0}
force -body engine -x 14000
