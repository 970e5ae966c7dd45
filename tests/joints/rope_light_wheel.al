# Atwood's machine over a wheel of a hundred thousandth of the weights (closed form).
# zero: line.length-2*0.95-0.1*pi
simulator -finish 0.6 -collisions 0
shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.1 0.04}}}
shape_set weight -desc {-sub {-box {0.1 0.1 0.1}}}
body w wheel -mass 1e-5 -init_pos {0 1 0}
joint axle -type hinge -body1 w
body a weight -mass 1 -init_pos {-0.1 0 0}
body b weight -mass 2 -init_pos {0.1 0 0}
rope line -points {{a {0 0.05 0}} {w {0 0 0} 0.1} {b {0 0.05 0}}}
foreach body {a b w} {force -body $body -gravitational {0 -9.81 0}}
