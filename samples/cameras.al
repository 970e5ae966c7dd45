# Views that move: a ball bounces past a row of posts. Besides a view that stands still there is one
# that follows the ball (its centre is an expression), one whose eye flies along a trajectory and looks
# at the ball, and one that turns about the scene (its rotation is an expression of time).

simulator -finish 8

shape_set ball -desc {-sub {-sphere 0.5}} -color tomato -shininess 0.7
shape_set ground -desc {-sub {-box {30 0.4 8}}} -color darkolivegreen
shape_set post -desc {-sub {-box {0.25 2 0.25}}} -color burlywood

body ground1 ground -fixed 1 -restitution 0.95 -init_pos {0 -0.2 0}
for {set i 0} {$i < 9} {incr i} {
    body post$i post -fixed 1 -init_pos [list [expr {3 * $i - 12}] 1 -2]
}
body ball1 ball -restitution 0.95 -init_pos {-12 4 0} -init_dpos {3 0 0}
force -body ball1 -gravitational {0 -9.81 0}

trajectory flight -points {{0 -14 5 10} {2.5 -6 2 7} {5 4 6 6} {8 15 3 5}}

view still -rot {0.25 0 0}
view follow -center {ball1.x ball1.y ball1.z} -scale 0.25
view along -eye flight -look {ball1.x ball1.y ball1.z}
view around -center {0 1 0} -rot {0 {0.25 * t} 0} -scale 0.08
