# A crane's trolley gains speed for 2 s, drives for 2 s and brakes for 2 s; its load swings on.
simulator -finish 8
shape_set trolley -desc {-sub {-box {0.6 0.2 0.6}}}
shape_set load -desc {-sub {-box {0.5 0.5 0.5}}}
body trolley trolley -mass 200
body load load -mass 500 -init_pos {0 -4 0}
joint rails -type slider -body1 trolley -axis {1 0 0} -speed {t < 2 ? t/2 : t < 4 ? 1 : t < 6 ? (6 - t)/2 : 0}
joint cable -type hinge -body1 load -offset1 {0 4 0} -body2 trolley
force -body load -gravitational {0 -9.81 0}
