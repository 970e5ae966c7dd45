# Balls are thrown with 15 m/s at 30, 45 and 60 degrees: 45 carries farthest, and 30 as far as 60. They slide on where they land.
simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set ground -desc {-sub {-plane}}
body floor ground -fixed 1
foreach {name degrees z} {low 30 -1 middle 45 0 high 60 1} {
    set a [expr {$degrees * acos(-1) / 180}]
    body $name ball -mass 0.5 -restitution 0 -init_pos [list 0 0.1 $z] -init_dpos [list [expr {15*cos($a)}] [expr {15*sin($a)}] 0]
    force -body $name -gravitational {0 -9.81 0}
}
