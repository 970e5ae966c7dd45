# Three balls on strings of 0.5 m are pushed at the lowest point. Only the green one is fast enough for
# the full circle: v^2 > 5 g r, or 4.952 m/s. The orange one (4.4 m/s) leaves the circle where
# cos a = (2 - v^2/(g r)) / 3 and falls on a parabola; the red one (2.8 m/s) swings to and fro.

simulator -finish 1.2

shape_set ball -desc {-sub {-sphere 0.05}}
shape_set nail -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.012 0.1} -color dimgray}}
shape_set wall -desc {-sub {-box {4.2 1.5 0.04} -color aliceblue}}
body wall wall -fixed 1 -init_pos {0 0 -0.1}
foreach {name x v color} {slow -1.3 2.8 crimson middle 0 4.4 darkorange fast 1.3 5.0 seagreen} {
    body nail_$name nail -fixed 1 -init_pos [list $x 0 -0.03]
    body $name ball -mass 0.1 -ct 1 -init_pos [list $x -0.5 0] -init_dpos [list $v 0 0] -color $color
    rope string_$name -points [list [list $x 0 0] [list $name {0 0 0}]]
    force -body $name -gravitational {0 -9.81 0}
}
plot tension -title "Tension of the strings" -values {string_slow.tension string_middle.tension string_fast.tension} \
    -labels {2.8 4.4 5.0}
view front -rot {0.06 0 0}
