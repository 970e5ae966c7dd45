# Three balls are thrown with the same speed, at 30, 45 and 60 degrees. Which one flies furthest?

simulator -finish 2

set speed 9

shape_set ground -desc {-sub {-box {18 0.3 4}}} -color darkseagreen
shape_set ball -desc {-sub {-sphere 0.25}} -shininess 0.5

body ground1 ground -fixed 1 -restitution 0.6 -init_pos {7.5 -0.4 0}
foreach {name degrees z color} {flat 30 -1 royalblue  middle 45 0 crimson  steep 60 1 darkorange} {
    set angle [expr {$degrees * acos(-1) / 180}]
    body $name ball -restitution 0.6 -color $color -init_pos [list 0 0 $z] \
        -init_dpos [list [expr {$speed * cos($angle)}] [expr {$speed * sin($angle)}] 0]
    force -body $name -gravitational {0 -9.81 0}
}

view side -rot {0.17 0 0}
