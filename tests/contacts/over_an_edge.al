# zero: a.y-1.1
# zero: c.y-1.1
simulator -finish 0.8
shape_set table -desc {-sub {-box {6 1 4}}}
shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}
body table table -fixed 1 -init_pos {-3 0.5 0} -friction 0.3
body a block -mass 2 -init_pos {-2 1.1 0} -friction 0.3 -restitution 0
body h block -mass 1 -init_pos {0.2 0.5 0}
body c block -mass 1 -init_pos {-3 1.1 0} -friction 0.3 -restitution 0
rope r -points {{a {0 0 0}} {0.2 1.1 0} {h {0 0 0}}}
contact on -body1 a -body2 table
contact stands -body1 table -body2 c
force -body a -gravitational {0 -9.81 0}
force -body h -gravitational {0 -9.81 0}
force -body c -gravitational {0 -9.81 0}
