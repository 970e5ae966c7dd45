# A buoy of half the density of water, pressed down by 0.1 m, bobs up and down: w^2 = 2 g / h.
simulator -finish 4
shape_set buoy -desc {-sub {-cylinder {0.2 0.4}}}
body buoy buoy -mass [expr {acos(-1)*0.04*0.4*500}] -init_pos {0 -0.1 0}
force -body buoy -gravitational {0 -9.81 0}
force -body buoy -y {9.81*1000*pi*0.04*max(0, min(0.4, 0.2 - buoy.y))}
