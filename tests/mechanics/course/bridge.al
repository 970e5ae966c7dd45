# A lorry of 3 t rolls with 2 m/s over a bridge of 10 m and 4 t: what it takes off one bearing it puts on the other.
simulator -finish 4
shape_set bridge -desc {-sub {-box {10 0.5 3}}}
shape_set lorry -desc {-sub {-box {1.5 1 1.5}}}
body bridge bridge -mass 4000 -restitution 0
body lorry lorry -mass 3000 -restitution 0 -init_pos {-4 0.75 0} -init_dpos {2 0 0}
joint bearing -type hinge -body1 bridge -offset1 {-5 0 0}
rope hanger -points {{bridge {5 0 0}} {5 4 0}}
foreach b {bridge lorry} {force -body $b -gravitational {0 -9.81 0}}
