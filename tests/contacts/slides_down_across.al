# zero: 0.8944271909999159*b.y+0.4472135954999579*b.z-0.05
simulator -finish 0.5
shape_set ramp -desc {-sub {-box {1 1 8}}}
shape_set box -desc {-sub {-box {0.2 0.1 0.4}}}
body ramp ramp -init_pos {0 -0.4472135954999579 -0.22360679774997896} -init_rot {0.4636476090008061 0 0} -fixed 1 -friction 0.3
body b box -init_pos {0 0.044721359549995794 0.022360679774997897} -init_rot {0.4636476090008061 0 0} -restitution 0 -mass 1 -friction 0.3
force -body b -gravitational {0 -9.81 0}
