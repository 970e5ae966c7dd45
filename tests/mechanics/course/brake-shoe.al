# A shoe is pressed with 50 N on the rim of a wheel (friction 0.4): the wheel slows down evenly, stops and stands.
simulator -finish 4
shape_set wheel -desc {-sub {-rot {1.5708 0 0} -cylinder {0.2 0.1}}}
shape_set shoe -desc {-sub {-box {0.1 0.1 0.1}}}
body wheel wheel -mass 5 -inertia {0.3 0.3 0.5} -friction 0.4 -restitution 0 -init_drot {0 0 20}
body shoe shoe -mass 0.5 -friction 0.4 -restitution 0 -init_pos {0 0.25 0}
joint axle -type hinge -body1 wheel
joint guide -type slider -body1 shoe -axis {0 1 0}
force -body shoe -y -50
