# Three balls in three bowls. The red one rolls and the blue one slides without friction, both from 57 degrees: to
# roll, a ball turns, too, and swings slower by sqrt(7/5), whatever it weighs. The third goes round at one height,
# at W = sqrt(g/(a cos q)), a = R - r: the wall bears its weight and holds it on its circle.

simulator -finish 6

set R 1            ;# of the hollow
set r 0.12         ;# of a ball
set q 1            ;# from the vertical
set a [expr {$R - $r}]
set W [expr {sqrt(9.81/($a*cos($q)))}]
set x [expr {$a*sin($q)}]
set y [expr {-$a*cos($q)}]

shape_set bowl -desc "-sub {-bowl {$R 1.06}}" -color wheat
shape_set red -desc "-sub {-sphere $r}" -color firebrick
shape_set blue -desc "-sub {-sphere $r}" -color royalblue
shape_set green -desc "-sub {-sphere $r}" -color seagreen

body wood bowl -fixed 1 -init_pos {-2.3 0 0} -friction 0.8
body ice bowl -fixed 1
body glass bowl -fixed 1 -init_pos {2.3 0 0}
body rolls red -mass 1 -restitution 0 -friction 0.8 -init_pos [list [expr {$x - 2.3}] $y 0]
body slides blue -mass 1 -restitution 0 -init_pos [list $x $y 0]
body circles green -mass 1 -restitution 0 -init_pos [list [expr {$x + 2.3}] $y 0] -init_dpos [list 0 0 [expr {-$W*$x}]]
foreach ball {rolls slides circles} {force -body $ball -gravitational {0 -9.81 0}}
view corner -rot {0.74 0 0}
