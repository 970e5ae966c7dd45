# A lamp hangs in a train. The train starts with 2 m/s^2 and the lamp swings about the direction in which weight and a together point.
simulator -finish 4
shape_set waggon -desc {-sub {-box {4 0.2 2}}}
shape_set lamp -desc {-sub {-sphere 0.1}}
body waggon waggon -mass 1000
body lamp lamp -mass 1 -init_pos {0 -1 0}
joint rails -type slider -body1 waggon -axis {1 0 0} -speed {2*t}
joint cord -type hinge -body1 lamp -offset1 {0 1 0} -body2 waggon
force -body lamp -gravitational {0 -9.81 0}
