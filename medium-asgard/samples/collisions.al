# Gliders on three air tracks. Equal ones change their speeds; a heavy one drives a light one on; of
# two that are soft both go on slowly.

simulator -finish 3

shape_set track -desc {-sub {-box {11 0.2 0.5}}} -color slategray
shape_set glider -desc {-sub {-box {0.8 0.5 0.9}}}
shape_set large -desc {-sub {-box {1.4 0.7 0.9}}}

foreach {name z striker mass keeps color} {
    equal 2.2  glider 1 1    crimson
    heavy 0    large  3 1    darkorange
    soft  -2.2 glider 1 0.15 seagreen
} {
    body track_$name track -fixed 1 -init_pos [list 0 -0.5 $z]
    body ${name}_1 $striker -mass $mass -restitution $keeps -color $color \
        -init_pos [list -4 0 $z] -init_dpos {2 0 0}
    body ${name}_2 glider -mass 1 -restitution $keeps -color lightsteelblue -init_pos [list 0 0 $z]
}

view above -rot {0.56 0 0}
