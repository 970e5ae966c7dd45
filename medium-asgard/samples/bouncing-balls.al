# Three balls fall on a floor. The first one is of rubber, the last one of clay: -restitution says how
# much of its speed a ball keeps.

simulator -finish 6

shape_set floor -desc {-sub {-box {8 0.3 4}}} -color lightsteelblue
shape_set ball -desc {-sub {-sphere 0.45}} -shininess 0.5

body floor1 floor -fixed 1 -init_pos {0 -0.15 0}
body rubber ball -restitution 0.9 -init_pos {-2.2 3.4 0} -color crimson
body wood ball -restitution 0.7 -init_pos {0 3.4 0} -color goldenrod
body clay ball -restitution 0.35 -init_pos {2.2 3.4 0} -color seagreen

force -body rubber -gravitational {0 -9.81 0}
force -body wood -gravitational {0 -9.81 0}
force -body clay -gravitational {0 -9.81 0}

view front -rot {0.18 0 0}
