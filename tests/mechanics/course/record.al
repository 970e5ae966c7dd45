# A record is laid on a turntable that turns with 3.5 rad/s: rubbing takes it along with the couple 2/3 mu m g R until it turns as the table.
simulator -finish 1
shape_set disc -desc {-sub {-cylinder {0.15 0.02}}}
body table disc -mass 2 -friction 0.3 -restitution 0
joint axle -type hinge -body1 table -axis {0 1 0} -speed 3.5
body record disc -mass 0.12 -friction 0.3 -restitution 0 -init_pos {0 0.02 0}
force -body record -gravitational {0 -9.81 0}
