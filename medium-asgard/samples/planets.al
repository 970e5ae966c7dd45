# Three planets round a sun: gravity draws each one to the middle, by the square of its distance.

simulator -finish 20 -collisions 0

set pull 40

shape_set sun -desc {-sub {-sphere 0.8}} -color gold
shape_set planet -desc {-sub {-sphere 0.25}} -shininess 0.3

body sun1 sun -fixed 1
foreach {name distance share color} {inner 2 1 sandybrown  middle 3.4 0.85 cornflowerblue  outer 5 1 indianred} {
    # `share` of the speed that a circle takes: less makes an ellipse.
    set speed [expr {$share * sqrt($pull / $distance)}]
    body $name planet -color $color -init_pos [list $distance 0 0] -init_dpos [list 0 0 -$speed]
    set r3 "hypot($name.x, $name.y, $name.z)^3"
    force -body $name -x "-$pull * $name.mass * $name.x / $r3" -y "-$pull * $name.mass * $name.y / $r3" \
        -z "-$pull * $name.mass * $name.z / $r3"
}

view tilted -rot {0.5 0 0}
