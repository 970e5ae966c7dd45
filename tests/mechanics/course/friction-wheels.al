# A wheel that turns is pressed with 20 N against one that stands: both rub until their rims go alike, one way and the other.
simulator -finish 3
shape_set large -desc {-sub {-rot {1.5708 0 0} -cylinder {0.3 0.1}}}
shape_set small -desc {-sub {-rot {1.5708 0 0} -cylinder {0.1 0.1}}}
shape_set fork -desc {-sub {-box {0.04 0.3 0.02}}}
body large large -mass 2 -inertia {0.05 0.05 0.09} -friction 0.25 -restitution 0 -init_drot {0 0 10}
body small small -mass 1 -inertia {0.005 0.005 0.01} -friction 0.25 -restitution 0 -init_pos {0 0.4 0}
body fork fork -mass 1 -init_pos {0 0.4 0.2} -ct 1
joint axle -type hinge -body1 large
joint guide -type slider -body1 fork -axis {0 1 0}
joint spindle -type hinge -body1 small -body2 fork
force -body fork -y -20
