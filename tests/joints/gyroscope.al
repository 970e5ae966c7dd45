# A wheel spins at 40 on an axle that is turned at 2 (closed form).
# zero: hypot(wheel.px(-0.5,0,0), wheel.py(-0.5,0,0), wheel.pz(-0.5,0,0))
simulator -finish 3
shape_set post -desc {-sub {-box {0.1 0.4 0.1}}}
shape_set wheel -desc {-sub {-box {0.1 0.4 0.4}}}
body post post -init_drot {0 2 0}
body wheel wheel -mass 3 -inertia {0.2 0.1 0.1} -init_pos {0.5 0 0} -init_dpos {0 0 -1} -init_drot {40 2 0}
joint turn -type hinge -body1 post -axis {0 1 0} -speed 2
joint axle -type hinge -body1 wheel -body2 post -axis {1 0 0}
