# A ball rolls down on two rails 0.12 m apart, its radius is 0.1 m: it touches them 0.08 m below its middle and is slower than on a plane.
simulator -finish 1.5
shape_set rail -desc {-sub {-box {6 0.1 0.04}}}
shape_set ball -desc {-sub {-sphere 0.1}}
set a 0.2
set down [list 0 0 [expr {-$a}]]
foreach {name z} {near 0.08 far -0.08} {
    body $name rail -fixed 1 -friction 0.5 -init_rot $down -init_pos [list [expr {-0.05*sin($a)}] [expr {-0.05*cos($a)}] $z]
}
body ball ball -mass 0.5 -friction 0.5 -restitution 0 -init_rot $down \
    -init_pos [list [expr {-2*cos($a) + 0.08*sin($a)}] [expr {2*sin($a) + 0.08*cos($a)}] 0]
force -body ball -gravitational {0 -9.81 0}
