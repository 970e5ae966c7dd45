simulator -finish 0.12
shape_set can -desc {-sub {-cylinder {0.1 0.3}}}
shape_set table -desc {-sub {-box {1 0.5 1}}}
body table table -fixed 1 -init_pos {-0.5 -0.25 0}
body b can -mass 1.0 -restitution 0 -init_pos {0.09878612363370887 0.14279042913410506 0.04849943427632645} -init_rot {-0.1 0.4 -0.9} -init_dpos {-0.03075896032801625 -0.03340937596358201 0.0} -init_drot {-1.0 -0.2 3.1}
force -body b -gravitational {0 -9.81 0}
