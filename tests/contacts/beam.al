# zero: box.y-0.35
simulator -finish 4
shape_set beam -desc {-sub {-box {4 0.2 0.5}}}
shape_set box -desc {-sub {-box {0.5 0.5 0.5}}}
body beam beam -mass 3 -friction 0.5 -restitution 0
body box box -mass 2 -init_pos {1 0.35 0} -friction 0.5 -restitution 0
joint pin -type hinge -body1 beam -offset1 {-2 0 0}
rope r -points {{beam {2 0 0}} {2 3 0}}
contact on -body1 box -body2 beam
force -body beam -gravitational {0 -9.81 0}
force -body box -gravitational {0 -9.81 0}
force -body box -x {t < 2 ? 4 : 0}
