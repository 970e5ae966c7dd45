# Billiard: the white ball strikes ten others on a table. Nothing is lost: no friction, elastic hits.

simulator -finish 6

shape_set ball -desc {-sub {-sphere 0.5}} -shininess 0.8
shape_set side -desc {-sub {-box {1 1 12}}} -color saddlebrown
shape_set end -desc {-sub {-box {20 1 1}}} -color saddlebrown
shape_set cloth -desc {-sub {-box {20 0.2 12}}} -color seagreen

set colors {gold mediumblue crimson purple darkorange forestgreen maroon cornflowerblue salmon limegreen}
set number 0
for {set row 0} {$row < 4} {incr row} {
    for {set place 0} {$place <= $row} {incr place} {
        # A hair's breadth apart, so that the order of the hits is clear.
        set x [expr {2.5 + $row * 0.8661}]
        set z [expr {($place - $row / 2.0) * 1.0001}]
        body ball$number ball -mass 1 -init_pos [list $x 0 $z] -color [lindex $colors $number]
        incr number
    }
}
body white ball -mass 1 -init_pos {-7 0 0.12} -init_dpos {14 0 0} -color ivory

body left side -fixed 1 -init_pos {-9.5 0 0}
body right side -fixed 1 -init_pos {9.5 0 0}
body near end -fixed 1 -init_pos {0 0 6.5}
body far end -fixed 1 -init_pos {0 0 -6.5}
# Below the balls, which nothing pulls down: a hair lower than their lowest points.
body table cloth -fixed 1 -init_pos {0 -0.61 0}

view above -rot {0.95 0 0}
