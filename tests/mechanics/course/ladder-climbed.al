# A man of 80 kg climbs a ladder of 10 kg that leans on a smooth wall at 60 degrees, on ground of friction 0.4: how far before its foot slips?
simulator -finish 3.5
shape_set ground -desc {-sub {-plane}}
shape_set ladder -desc {-sub {-box {4 0.04 0.4}}}
shape_set man -desc {-sub {-sphere 0.2}}
set a [expr {acos(-1)/3}]
set up [expr {acos(-1) - $a}]
# The point lies that far up the ladder from its middle; its lower corner stands on the ground, its upper one at the wall.
proc on_ladder {s} {
    global a
    return [list [expr {(2 - $s)*cos($a) + 0.02*sin($a)}] [expr {(2 + $s)*sin($a) + 0.02*cos($a)}] 0]
}
body floor ground -fixed 1 -friction 0.4
body wall ground -fixed 1 -init_rot {0 0 -1.5708}
body ladder ladder -mass 10 -friction 0.4 -restitution 0 -init_rot [list 0 0 $up] -init_pos [on_ladder 0]
body man man -mass 80 -init_rot [list 0 0 $up] -init_pos [on_ladder -1.5]
joint climb -type slider -body1 man -body2 ladder -axis {1 0 0} -speed {min(t, 1)}
contact foot -body1 ladder -body2 floor
contact head -body1 ladder -body2 wall
foreach b {ladder man} {force -body $b -gravitational {0 -9.81 0}}
