# Five gliders on an air track, joined by six equal springs. The first is drawn aside and let go: its push
# wanders to the other end and back. It is a sum of five natural vibrations, w_k = 2 sqrt(K/m) sin(k pi/12).

parameter stiffness -value 20 -min 5 -max 60 -label "stiffness of the springs" -unit N/m
simulator -finish 8

shape_set glider -desc {-sub {-box {0.12 0.1 0.1}}}
shape_set track -desc {-sub {-pos {0 -0.085 0} -box {2.6 0.06 0.16} -color slategray} -sub {-pos {-1.22 0 0} -box {0.04 0.1 0.1} -color slategray}
    -sub {-pos {1.22 0 0} -box {0.04 0.1 0.1} -color slategray}}
body track track -fixed 1
set before track
set place {-1.2 0 0}
foreach {name x color} {g1 -0.8 crimson g2 -0.4 darkorange g3 0 gold g4 0.4 seagreen g5 0.8 royalblue} {
    body $name glider -mass 0.2 -color $color -init_pos [list [expr {$name eq "g1" ? $x - 0.15 : $x}] 0 0]
    spring -body1 $name -body2 $before -offset2 $place -stiffness $stiffness -rest 0.4
    set before $name
    set place {0 0 0}
}
spring -body1 g5 -x 1.2 -y 0 -z 0 -stiffness $stiffness -rest 0.4

plot places -title "Places of the gliders" -values {g1.x g2.x g3.x g4.x g5.x} -labels {1 2 3 4 5}
view above -rot {0.38 -0.06 -0.01}
