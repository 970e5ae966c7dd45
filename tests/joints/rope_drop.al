# A ball falls from the point where its rope is tied, and hops on the rope's end until it hangs (closed form).
# zero: b.x
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body b ball -mass 2
force -body b -gravitational {0 -9.81 0}
rope r -points {{0 0 0} {b {0 0 0}}} -length 1 -restitution 0.5
