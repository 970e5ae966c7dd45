# Three parcels are set on a belt that runs at 1.5 m/s. Each slides back over the belt until friction
# has brought it to the belt's speed, after t = v / (mu g): the smooth one latest. Meanwhile the belt
# has run v t under it, and the parcel half as far.

simulator -finish 3

shape_set belt -desc {-sub {-box {5.4 0.08 1.6}}} -color dimgray
shape_set roller -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.12 1.64}}} -color silver
shape_set parcel -desc {-sub {-box {0.3 0.2 0.26}}}
body belt belt -fixed 1 -init_pos {1.9 -0.04 0} -friction 1 -surface_velocity {1.5 0 0}
body first roller -fixed 1 -init_pos {-0.8 -0.16 0}
body last roller -fixed 1 -init_pos {4.6 -0.16 0}
foreach {name mu z color} {cardboard 0.49 -0.5 peru wood 0.25 0 goldenrod steel 0.09 0.5 steelblue} {
    body $name parcel -mass 1 -restitution 0 -friction $mu -init_pos [list -0.4 0.1 $z] -color $color
    force -body $name -gravitational {0 -9.81 0}
}
plot speed -title "Speed of each parcel" -values {cardboard.dx wood.dx steel.dx} -labels {cardboard wood steel}
view above -rot {0.58 0 0}
