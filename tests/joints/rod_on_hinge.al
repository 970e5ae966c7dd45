# A rod of 1 m falls about a hinge at its end, from the horizontal (elliptic functions).
# zero: rod.px(-0.5,0,0)
# zero: rod.py(-0.5,0,0)
simulator -finish 3
shape_set rod -desc {-sub {-box {1 0.02 0.02}}}
body rod rod -mass 2 -inertia [list 0.001 [expr {2/12.0}] [expr {2/12.0}]] -init_pos {0.5 0 0}
force -body rod -gravitational {0 -9.81 0}
joint pin -type hinge -body1 rod -offset1 {-0.5 0 0}
