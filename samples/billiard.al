# Collisions: fifteen balls at rest in a triangle, one that strikes them, four cushions; all elastic, no
# friction. Loops of Tcl make the rack.

simulator -finish 8

shape_set ball -desc {-sub {-sphere 0.5}} -shininess 0.8
shape_set side -desc {-sub {-box {1 1 14}}} -color saddlebrown
shape_set end -desc {-sub {-box {26 1 1}}} -color saddlebrown
shape_set cloth -desc {-sub {-box {26 0.2 14}}} -color seagreen

set colors {gold mediumblue red purple darkorange forestgreen maroon black
    khaki cornflowerblue salmon orchid sandybrown limegreen brown}
set number 0
for {set row 0} {$row < 5} {incr row} {
    for {set place 0} {$place <= $row} {incr place} {
        # A hair's breadth apart, so that the order of the hits is clear.
        set x [expr {4 + $row * 0.8661}]
        set z [expr {($place - $row / 2.0) * 1.0001}]
        body ball$number ball -mass 1 -init_pos [list $x 0 $z] -color [lindex $colors $number]
        incr number
    }
}
body cue ball -mass 1 -init_pos {-8 0 0.12} -init_dpos {14 0 0} -color ivory

body left side -fixed 1 -init_pos {-12.5 0 0}
body right side -fixed 1 -init_pos {12.5 0 0}
body near end -fixed 1 -init_pos {0 0 7.5}
body far end -fixed 1 -init_pos {0 0 -7.5}
# Below the balls, which nothing pulls down: a hair lower than their lowest points.
body table cloth -fixed 1 -init_pos {0 -0.61 0}

view above -rot {1.06 0 0}
