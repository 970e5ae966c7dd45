# On three air tracks a glider of 1 kg comes with 2 m/s to one of 3 kg: springs between them, soft wood, and putty.
simulator -finish 2
shape_set glider -desc {-sub {-box {0.2 0.1 0.1}}}
foreach {name e z} {springs 1 0 wood 0.5 1 putty 0 2} {
    body one_$name glider -mass 1 -restitution $e -init_pos [list -1 0 $z] -init_dpos {2 0 0}
    body two_$name glider -mass 3 -restitution $e -init_pos [list 0 0 $z]
}
