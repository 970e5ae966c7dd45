# A bicycle wheel spins on one end of its axle, which a stand carries as a ball joint. It does not fall:
# it goes round, nearly at m g s / (I w) = 1.09 rad/s, and nods a little. (Own integration of Euler's
# equations.)

parameter spin -value 30 -min 5 -max 60 -label "spin of the wheel" -unit rad/s
simulator -finish 4

set half_turn [expr {acos(-1) / 2}]
set parts "-sub {-rot {0 0 $half_turn} -cylinder {0.02 0.4} -color gray} -sub {-pos {0 0 0} -rot {0 0 $half_turn} -cylinder {0.05 0.06} -color gray}"
for {set i 0} {$i < 24} {incr i} {
    set a [expr {$i * acos(-1) / 12}]
    set color [expr {$i % 12 ? "darkslategray" : "orange"}]
    append parts " -sub {-pos {0 [expr {0.3*cos($a)}] [expr {0.3*sin($a)}]} -rot {$a 0 0} -box {0.04 0.03 0.084} -color $color}"
    if {$i % 3 == 0} {
        append parts " -sub {-pos {0 [expr {0.15*cos($a)}] [expr {0.15*sin($a)}]} -rot {$a 0 0} -box {0.012 0.26 0.012} -color silver}"
    }
}
shape_set wheel -desc $parts
shape_set stand -desc {-sub {-pos {0 -0.33 0} -cylinder {0.03 0.6} -color slategray} -sub {-pos {0 -0.65 0} -cylinder {0.2 0.04} -color slategray}}
body stand stand -fixed 1 -ct 1
body wheel wheel -ct 1 -mass 2 -inertia {0.12 0.065 0.065} -center {0 0 0} -init_pos {0.2 0 0} -init_drot [list $spin 0 0]
joint pivot -type ball -body1 wheel -offset1 {-0.2 0 0}
force -body wheel -gravitational {0 -9.81 0}

plot height -title "How the wheel nods" -values {wheel.y} -labels {height}
view corner -rot {0.25 -0.38 -0.05}
