simulator -finish 0.2
shape_set glass -desc {-sub {-cylinder {0.03 0.12}}}
shape_set board -desc {-sub {-box {0.8 0.05 0.6}}}
body board board -fixed 1 -init_pos {0.4 -0.025 0} -friction 2
body b glass -mass 1.0 -restitution 0 -init_pos {-0.01 0.06 0.0} -friction 2
force -body b -gravitational {0 -9.81 0}
