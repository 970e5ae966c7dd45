# An arch of seven blocks of stone stands without mortar: each joint is pressed together, under an angle
# that friction (0.6) holds. A lamp of 4.6 kg swings on a hook below the keystone, and pulls the feet to and
# fro: together they bear the arch, 6078.1 N, and what the lamp pulls upwards and downwards. No stone moves.

simulator -finish 2

set blocks 7
set inner 0.7
set outer 1.0
set step [expr {acos(-1) / $blocks}]
for {set i 0} {$i < $blocks} {incr i} {
    set points {}
    # Seen from the middle of the block.
    set mx [expr {0.85*cos(($i + 0.5)*$step)}]
    set my [expr {0.85*sin(($i + 0.5)*$step)}]
    foreach a [list [expr {$i*$step}] [expr {($i + 1)*$step}]] {
        foreach r [list $inner $outer] {
            foreach z {-0.2 0.2} {
                lappend points [list [expr {$r*cos($a) - $mx}] [expr {$r*sin($a) - $my}] $z]
            }
        }
    }
    shape_set block$i -desc [list -sub [list -points $points]] -color [lindex {tan burlywood} [expr {$i % 2}]]
    body stone$i block$i -density 2000 -restitution 0 -friction 0.6 -init_pos [list $mx $my 0]
    force -body stone$i -gravitational {0 -9.81 0}
}
# The hook sits in the keystone, just above its lower face, 0.35 from the middle of the ball.
set swing 0.5
shape_set lamp -desc {-sub {-sphere 0.06} -sub {-pos {0 0.205 0} -cylinder {0.005 0.29}}} -color gold
body lamp lamp -density 5000 -init_pos [list [expr {0.35*sin($swing)}] [expr {0.7 - 0.35*cos($swing)}] 0] -init_rot "0 0 $swing"
force -body lamp -gravitational {0 -9.81 0}
joint hook -type hinge -body1 stone3 -offset1 {0 -0.15 0} -body2 lamp -axis {0 0 1}
shape_set ground -desc {-sub {-box {3 0.1 1.2} -color darkseagreen}}
body ground ground -fixed 1 -friction 0.6 -init_pos {0 -0.05 0}
contact left -body1 stone6 -body2 ground
contact right -body1 stone0 -body2 ground

plot feet -title "Load on the feet, in N" -values {left.n right.n} -labels {left right}
view front -rot {0.16 -0.24 -0.02}
