# Two bodies sink on screws, right-handed and left-handed (closed form).
# zero: nut.y - 0.3*turn.q/(2*pi)
# zero: left.y + 0.7*back.q/(2*pi)
# zero: nut.x
simulator -finish 3
shape_set nut -desc {-sub {-box {0.4 0.2 0.4}}}
body nut nut -mass 2 -inertia {0.1 0.05 0.1}
body left nut -mass 2 -inertia {0.1 0.05 0.1} -init_pos {3 0 0}
force -body nut -gravitational {0 -9.81 0}
force -body left -gravitational {0 -9.81 0}
joint turn -type screw -body1 nut -axis {0 1 0} -pitch 0.3
joint back -type screw -body1 left -axis {0 1 0} -pitch -0.7
