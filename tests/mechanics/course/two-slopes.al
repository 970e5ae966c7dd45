# Two blocks on a roof of 30 and 60 degrees hang together by a thread over its ridge (friction 0.1): which way, and how fast?
simulator -finish 1
shape_set roof -desc {-sub {-points {{-1.7320508075688772 -1 -0.3} {0 0 -0.3} {0.57735026918962573 -1 -0.3} {-1.7320508075688772 -1 0.3} {0 0 0.3} {0.57735026918962573 -1 0.3}}}}
shape_set block -desc {-sub {-box {0.2 0.1 0.2}}}
set a [expr {acos(-1)/6}]
set b [expr {acos(-1)/3}]
body roof roof -fixed 1 -friction 0.1
# The blocks lie so far down a slope and 0.05 above it; the thread goes over the point that is 0.05 above both.
body left block -mass 4 -friction 0.1 -restitution 0 -init_rot [list 0 0 $a] \
    -init_pos [list [expr {-0.5*cos($a) - 0.05*sin($a)}] [expr {-0.5*sin($a) + 0.05*cos($a)}] 0]
body right block -mass 1 -friction 0.1 -restitution 0 -init_rot [list 0 0 [expr {-$b}]] \
    -init_pos [list [expr {0.8*cos($b) + 0.05*sin($b)}] [expr {-0.8*sin($b) + 0.05*cos($b)}] 0]
rope thread -points [list {left} [list [expr {0.05*(cos($a) - cos($b))/sin($a + $b)}] [expr {0.05*(sin($a) + sin($b))/sin($a + $b)}] 0] {right}]
foreach block {left right} {force -body $block -gravitational {0 -9.81 0}}
