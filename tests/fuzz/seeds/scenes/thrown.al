# Led, then free: for its first two seconds a ball is swung round an arc by a trajectory, as by a hand; then
# the trajectory lets go, and the ball flies on with the velocity that it has, under gravity alone, and
# bounces along the floor. The small balls mark the arc.

simulator -finish 5

set gravity 9.81

shape_set ball -desc {-sub {-sphere 0.35}} -color crimson -shininess 0.6
shape_set ground -desc {-sub {-box {24 0.5 6}}} -color darkseagreen
shape_set mark -desc {-sub {-sphere 0.07}} -color gray

body ground1 ground -fixed 1 -restitution 0.85 -init_pos {6 -0.25 0}

# Points on an arc about the shoulder, gathering speed: {t x y z} for each.
set points {}
for {set i 0} {$i <= 8} {incr i} {
    set t [expr {$i / 4.0}]
    set angle [expr {-2.6 + 3.1 * ($t / 2) ** 2}]
    set x [expr {2 * sin($angle)}]
    set y [expr {2.6 - 2 * cos($angle)}]
    lappend points [list $t $x $y 0]
    body mark$i mark -fixed 1 -ct 1 -init_pos [list $x $y -0.5]
}

trajectory hand -points $points
body ball1 ball -restitution 0.85 -ct 1 -init_pos [lrange [lindex $points 0] 1 3]
constrain ball1 -pos hand
force -body ball1 -gravitational [list 0 -$gravity 0]
