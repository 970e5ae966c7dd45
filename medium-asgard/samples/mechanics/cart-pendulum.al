# A motor balances a pole on a cart: it reads the pole's angle and the cart's place, and their rates. Where
# the pole leans, there the cart goes. The answer is an own integration of place and angle.

parameter lean -value 0.3 -min -0.5 -max 0.5 -label "how the pole leans at first" -unit rad
simulator -finish 6

shape_set cart -desc {-sub {-box {0.4 0.12 0.24} -color steelblue}}
shape_set pole -desc {-sub {-box {0.04 0.8 0.04} -color goldenrod} -sub {-pos {0 0.42 0} -sphere 0.05 -color firebrick}}
shape_set rail -desc {-sub {-pos {0 -0.09 0} -box {3 0.04 0.3} -color slategray}}
body rail rail -fixed 1 -ct 1
body cart cart -ct 1 -mass 1
body pole pole -ct 1 -mass 0.2 -inertia {0.0107 0.001 0.0107} -center {0 0 0} -init_rot [list 0 0 $lean] \
    -init_pos [list [expr {-0.4*sin($lean)}] [expr {0.4*cos($lean)}] 0]
joint track -type slider -body1 cart -axis {1 0 0} \
    -motor {3*track.q + 4*track.dq - 45*(pivot.q + lean) - 10*pivot.dq}
joint pivot -type hinge -body1 pole -offset1 {0 -0.4 0} -body2 cart -offset2 {0 0 0}
force -body pole -gravitational {0 -9.81 0}

plot state -title "Place of the cart, angle of the pole" -values {track.q pivot.q+lean} -labels {place angle}
view front -rot {0.17 -0.17 -0.01}
