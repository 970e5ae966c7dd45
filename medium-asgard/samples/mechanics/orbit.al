# A comet on an ellipse round a sun (e = 0.6): near it fast, far off slow, equal areas in equal times. The
# place at each time follows from Kepler's equation E - e sin E = 2 pi t / T.

simulator -finish 7

shape_set sun -desc {-sub {-sphere 0.12}} -color gold
shape_set comet -desc {-sub {-sphere 0.04}} -color deepskyblue
body sun sun -fixed 1
body comet comet -mass 1 -init_pos {0.4 0 0} -init_dpos {0 0 -4}
force -body comet -x {-4*comet.x/hypot(comet.x,comet.z)^3} -y 0 -z {-4*comet.z/hypot(comet.x,comet.z)^3}
view above -rot {0.84 0 0}
