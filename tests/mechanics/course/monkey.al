# A hunter aims at a monkey, who lets go of the branch at the shot: the dart meets it wherever both are by then.
simulator -finish 0.8
shape_set dart -desc {-sub {-sphere 0.05}}
shape_set monkey -desc {-sub {-sphere 0.2}}
body dart dart -mass 0.1 -restitution 0.2 -init_dpos {16 12 0}
body monkey monkey -mass 4 -restitution 0.2 -init_pos {8 6 0}
foreach b {dart monkey} {force -body $b -gravitational {0 -9.81 0}}
