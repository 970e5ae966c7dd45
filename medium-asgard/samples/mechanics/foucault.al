# Foucault's pendulum, 2 m long, at the pole of a small planet that turns once in 60 s. Seen from its
# ground the swing turns back by 6 degrees each second: Coriolis' force 2 m v x W turns the path.

parameter day -value 60 -min 20 -max 600 -label "length of a day" -unit s
simulator -finish 15

shape_set bob -desc {-sub {-sphere 0.08}} -color goldenrod
shape_set hook -desc {-sub {-pos {0 0.02 0} -box {0.3 0.04 0.3}}} -color saddlebrown
shape_set floor -desc {-sub {-pos {0 -2.2 0} -cylinder {0.9 0.04} -color lightsteelblue} -sub {-pos {0 -2.178 0} -box {1.7 0.004 0.01} -color firebrick}}
body hook hook -fixed 1 -ct 1
body floor floor -fixed 1
body bob bob -mass 2 -init_pos {0.6 -1.9078784028338913 0}
joint wire -type distance -body1 bob -offset2 {0 0 0}
force -body bob -gravitational {0 -9.81 0}
# W = 2 pi / day upwards; the centrifugal force counts, too.
force -body bob -x {-2*bob.mass*(2*pi/day)*bob.dz + bob.mass*(2*pi/day)^2*bob.x} -y 0 \
    -z {2*bob.mass*(2*pi/day)*bob.dx + bob.mass*(2*pi/day)^2*bob.z}

view corner -rot {0.34 -0.28 -0.05}
