# Two stars of 2 and 1 go round their common centre of mass under their own gravity: w^2 d^3 = G (M + m).
simulator -finish 12
shape_set sun -desc {-sub {-sphere 0.1}}
set w [expr {sqrt(3.0)}]
body heavy sun -mass 2 -init_pos [list [expr {-1/3.0}] 0 0] -init_dpos [list 0 [expr {-$w/3}] 0]
body light sun -mass 1 -init_pos [list [expr {2/3.0}] 0 0] -init_dpos [list 0 [expr {2*$w/3}] 0]
foreach {a b} {heavy light light heavy} {
    force -body $a -x "2*($b.x - $a.x)/hypot($b.x - $a.x, $b.y - $a.y)^3" -y "2*($b.y - $a.y)/hypot($b.x - $a.x, $b.y - $a.y)^3"
}
