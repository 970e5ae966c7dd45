# A weight swings on a spring: it goes up and down and to and fro, and each feeds the other.
simulator -finish 6
shape_set weight -desc {-sub {-sphere 0.08}}
body weight weight -mass 1 -init_pos {0.3 -1.2 0}
spring coil -body1 weight -x 0 -y 0 -z 0 -stiffness 40 -rest 1
force -body weight -gravitational {0 -9.81 0}
