# A man of 80 kg walks 3 m along a boat of 120 kg: the boat goes back by 1.2 m, and their centre of mass stays.
simulator -finish 5
shape_set boat -desc {-sub {-box {5 0.4 1.2}}}
shape_set man -desc {-sub {-box {0.3 1.8 0.4}}}
body boat boat -mass 120
body man man -mass 80 -init_pos {-1.5 1.1 0}
joint water -type slider -body1 boat -axis {1 0 0}
joint walk -type slider -body1 man -body2 boat -axis {1 0 0} -position {t < 4 ? 3*(t/4)^2*(3 - t/2) : 3}
foreach b {boat man} {force -body $b -gravitational {0 -9.81 0}}
