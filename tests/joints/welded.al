# Three welded boxes fly and tumble as one body (own integration of Euler's equations).
# zero: hypot(a.px(1,0,0) - b.px(0,-0.5,0), a.py(1,0,0) - b.py(0,-0.5,0), a.pz(1,0,0) - b.pz(0,-0.5,0))
simulator -finish 3
shape_set box -desc {-sub {-box {1 0.4 0.6}}}
body a box -mass 2 -init_dpos {1 2 3} -init_drot {1 2 3}
body b box -mass 1 -init_pos {1 0.5 0} -init_dpos [list [expr {1 - 1.5}] [expr {2 + 3}] [expr {3 + 0.5 - 2}]] -init_drot {1 2 3}
body c box -mass 0.5 -init_pos {0 0 1} -init_dpos [list [expr {1 + 2}] [expr {2 - 1}] 3] -init_drot {1 2 3}
foreach name {a b c} {force -body $name -gravitational {0 -9.81 0}}
joint ab -type fixed -body1 b -offset1 {0 -0.5 0} -body2 a -offset2 {1 0 0}
joint ac -type fixed -body1 c -body2 a
