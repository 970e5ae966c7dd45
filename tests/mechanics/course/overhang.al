# Books lie over the edge of a table, each farther out than the one below: 1/2, 1/4, 1/6 and 1/8 of a book are the most, 0.99 of it stands.
simulator -finish 100
shape_set table -desc {-sub {-box {2 1 1}}}
shape_set book -desc {-sub {-box {0.24 0.03 0.16}}}
body table table -fixed 1 -friction 0.4 -init_pos {-1 -0.5 0}
set x -0.12
foreach n {4 3 2 1} {
    set x [expr {$x + 0.99*0.24/(2*$n)}]
    body book$n book -mass 1 -friction 0.4 -restitution 0 -init_pos [list $x [expr {0.03*(4 - $n) + 0.015}] 0]
    force -body book$n -gravitational {0 -9.81 0}
}
