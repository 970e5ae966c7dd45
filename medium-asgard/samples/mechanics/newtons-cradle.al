# Newton's cradle: five steel balls hang side by side on threads of 0.5 m. The first is drawn aside by half
# a radian and let go; the last one leaves, as high, and comes back. Between two clicks pass half a swing,
# 2 K(sin 1/4) sqrt(l/g) = 0.7205 s.

simulator -finish 4

shape_set ball -desc {-sub {-sphere 0.05}} -color silver -shininess 0.9
shape_set bar -desc {-sub {-box {0.7 0.02 0.02}}} -color slategray
body near bar -fixed 1 -init_pos {0 0.01 0.2}
body far bar -fixed 1 -init_pos {0 0.01 -0.2}
for {set i 1} {$i <= 5} {incr i} {
    set x [expr {($i - 3) * 0.1}]
    set a [expr {$i == 1 ? -0.5 : 0.0}]
    body ball$i ball -mass 0.2 -init_pos [list [expr {$x + 0.5*sin($a)}] [expr {-0.5*cos($a)}] 0]
    rope left$i -points [list [list $x 0 0.2] [list ball$i {0 0 0}]]
    rope right$i -points [list [list $x 0 -0.2] [list ball$i {0 0 0}]]
    force -body ball$i -gravitational {0 -9.81 0}
}
view front -rot {0.16 -0.31 -0.03}
