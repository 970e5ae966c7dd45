# Forces that depend on time: one push, the same for all, shakes seven balls on springs of different
# stiffness. Only the one whose own rhythm it is (the orange one) swings out further and further.

simulator -finish 30 -collisions 0

parameter push -value 0.35 -min 0 -max 1 -label "strength of the push" -unit N
parameter rhythm -value 3 -min 1 -max 5 -label "rhythm of the push" -unit rad/s

shape_set ball -desc {-sub {-sphere 0.4}}

set number 0
foreach {own color} {
    1.5 midnightblue  2 royalblue  2.5 cornflowerblue  3 darkorange  3.5 cornflowerblue
    4 royalblue  4.5 midnightblue
} {
    incr number
    set name ball$number
    body $name ball -mass 1 -color $color -init_pos [list [expr {1.2 * ($number - 4)}] 0 0]
    # A spring to its height of rest, a little drag, and the push.
    force -body $name -y "-$own^2 * $name.y - 0.05 * $name.dy + push * cos(rhythm * t)"
}

plot heights -title "Height of each ball" -values {ball1.y ball2.y ball3.y ball4.y ball5.y} \
    -labels {1.5 2 2.5 3 3.5}
