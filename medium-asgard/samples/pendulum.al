# A pendulum: a bob on a rod that hangs on a beam. It is let go at the side.

simulator -finish 10 -collisions 0

shape_set beam -desc {-sub {-box {1.8 0.12 0.6}}} -color slategray
shape_set swing -desc {
    -sub {-pos {0 -0.85 0} -box {0.07 1.7 0.07} -color gray}
    -sub {-pos {0 -2 0} -sphere 0.3 -color crimson}
}

body beam1 beam -fixed 1 -init_pos {0 0.06 0}
# Turned by 0.8 radian about the point that it hangs on, which is the shape's origin.
body pendulum swing -init_rot {0 0 0.8}
link -body1 pendulum -offset1 {0 0 0} -x 0 -y 0 -z 0 -tightness 50000
force -body pendulum -gravitational {0 -9.81 0}

view front -rot {0.11 0 0}
