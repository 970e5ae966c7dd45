# A block is thrown up a board of 30 degrees (friction 0.4, static 0.7). It slows down evenly by
# g (sin a + mu cos a), stops after s = v^2 / (2 g (sin a + mu cos a)) and stays there for good, since
# tan a = 0.577 is less than 0.7. At 4 m/s: t = 0.4816 s, s = 0.9633 m.

parameter degrees -value 30 -min 5 -max 45 -label "slope of the board"
parameter speed -value 4 -min 1 -max 4.5 -label "speed of the throw" -unit m/s
simulator -finish 2

set a [expr {$degrees * acos(-1) / 180}]
set up [list [expr {cos($a)}] [expr {sin($a)}] 0]
# A point so far up the board and so high over it.
proc on_board {s h} {
    global a
    return [list [expr {$s*cos($a) - $h*sin($a)}] [expr {$s*sin($a) + $h*cos($a)}] 0]
}

shape_set board -desc {-sub {-box {1.9 0.06 0.5}}} -color burlywood
shape_set block -desc {-sub {-box {0.24 0.16 0.2}}} -color firebrick
shape_set table -desc {-sub {-box {2.4 0.06 0.9}}} -color slategray
body table table -fixed 1 -init_pos {0.78 -0.05 0}
body board board -fixed 1 -init_pos [on_board 0.9 -0.03] -init_rot [list 0 0 $a] -friction 0.4 -static_friction 0.7
body block block -init_pos [on_board 0.15 0.08] -init_rot [list 0 0 $a] -mass 1 -restitution 0 \
    -friction 0.4 -static_friction 0.7 -init_dpos [list [expr {$speed*cos($a)}] [expr {$speed*sin($a)}] 0]
force -body block -gravitational {0 -9.81 0}

plot speed -title "Speed" -values {hypot(block.dx,block.dy)} -labels {block}
lightsource sun -direction {-0.4 -1 -0.7}
view side -rot {0.25 0.09 0.01}
