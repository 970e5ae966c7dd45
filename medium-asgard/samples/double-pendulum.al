# A double pendulum: a second rod hangs on the first one. Nobody foresees its motion for long.

simulator -finish 12 -collisions 0

shape_set beam -desc {-sub {-box {1.2 0.12 0.6}}} -color slategray
shape_set upper -desc {
    -sub {-pos {0 0.08 0} -box {0.12 1.24 0.12} -color steelblue}
    -sub {-pos {0 -0.7 0} -sphere 0.16 -color steelblue}
}
shape_set lower -desc {
    -sub {-pos {0 0.1 0} -box {0.1 1 0.1} -color darkorange}
    -sub {-pos {0 -0.6 0} -sphere 0.2 -color darkorange}
}

body beam1 beam -fixed 1 -init_pos {0 0.06 0}
# Both lie level at first: turned by a right angle.
body rod1 upper -artbody pendulum -init_pos {0.7 0 0} -init_rot {0 0 1.5708} -mass 2
body rod2 lower -artbody pendulum -init_pos {2 0 0.16} -init_rot {0 0 1.5708} -mass 1

link -body1 rod1 -offset1 {0 0.7 0} -x 0 -y 0 -z 0 -tightness 50000
link -body1 rod2 -offset1 {0 0.6 -0.16} -body2 rod1 -offset2 {0 -0.7 0} -tightness 50000

force -body rod1 -gravitational {0 -9.81 0}
force -body rod2 -gravitational {0 -9.81 0}

view front -rot {0.08 0 0}
