# A spring and sliding friction, written as expressions. Three blocks are pulled aside and let go: on
# ice, on wood, and on a rough board. Friction is mu m g against the motion; tanh carries it through
# zero within a few millimetres per second, so that a block at rest stays at rest.

simulator -finish 12 -collisions 0

parameter stiffness -value 20 -min 5 -max 80 -label "stiffness of the springs" -unit N/m

shape_set block -desc {-sub {-box {0.8 0.5 0.6}}}
shape_set board -desc {-sub {-box {6 0.1 0.9}}}
shape_set post -desc {-sub {-box {0.12 0.8 0.9}}} -color dimgray

foreach {name mu z color boardColor} {
    ice   0.005 -1.4 deepskyblue azure
    wood  0.08   0   peru        burlywood
    rough 0.3    1.4 firebrick   darkgray
} {
    body $name block -mass 1 -init_pos [list 2 0 $z] -color $color
    body board_$name board -fixed 1 -init_pos [list 0 -0.3 $z] -color $boardColor
    body post_$name post -fixed 1 -init_pos [list -3 0.1 $z]
    force -body $name \
        -x "-stiffness * $name.x - $mu * $name.mass * 9.81 * tanh($name.dx / 0.005)"
}

plot positions -title "Distance from rest" -values {ice.x wood.x rough.x} -labels {ice wood rough}

view side -rot {0.43 -0.28 -0.06}
