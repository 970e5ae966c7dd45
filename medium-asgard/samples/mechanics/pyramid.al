# Six boxes in a pyramid stand on a plate that shakes to and fro by 1 cm, twice a second. Friction of 0.5
# holds up to an acceleration of 0.5 g = 4.9 m/s^2, and the plate has 1.58 m/s^2 at most: so all boxes go
# with the plate, and none slides by a hair.

simulator -finish 2

shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}
shape_set plate -desc {-sub {-box {1.2 0.06 0.6} -color slategray}}
body plate plate -mass 20 -restitution 0 -friction 0.5 -init_pos {0 -0.03 0}
joint drive -type slider -body1 plate -axis {1 0 0} -position {0.01*(1 - cos(4*pi*t))}
foreach {name x row color} {
    a -0.22 0 crimson  b 0 0 darkorange  c 0.22 0 gold  d -0.11 1 seagreen  e 0.11 1 royalblue  f 0 2 orchid
} {
    body $name box -mass 5 -restitution 0 -friction 0.5 -color $color -init_pos [list $x [expr {0.1 + 0.2*$row}] 0]
    force -body $name -gravitational {0 -9.81 0}
}
view front -rot {0.23 -0.3 -0.04}
