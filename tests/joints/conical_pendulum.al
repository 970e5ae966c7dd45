# A rod on a ball joint goes round, inclined by 0.7 (steady motion).
# zero: hypot(rod.px(0,0.5,0), rod.py(0,0.5,0), rod.pz(0,0.5,0))
simulator -finish 4
shape_set rod -desc {-sub {-box {0.04 1 0.04}}}
set a 0.7
set about [expr {(1 + 0.0016)/12 + 0.25}]
set along [expr {0.0032/12}]
set rate [expr {sqrt(9.81*0.5/(cos($a)*($about - $along)))}]
body rod rod -mass 1 -init_pos [list [expr {0.5*sin($a)}] [expr {-0.5*cos($a)}] 0] -init_rot [list 0 0 $a] \
    -init_dpos [list 0 0 [expr {-$rate*0.5*sin($a)}]] -init_drot [list 0 $rate 0]
force -body rod -gravitational {0 -9.81 0}
joint pin -type ball -body1 rod -offset1 {0 0.5 0}
