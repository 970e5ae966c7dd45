# A jump from a bridge on a rubber rope of 12 m (K = 120 N/m, 70 kg): free fall as far as the rope is long,
# then half a vibration. The lowest point is where the rope has taken all the energy: 30.76 m down.

simulator -finish 12

shape_set bridge -desc {-sub {-pos {0 0.5 0} -box {30 1 6} -color slategray} -sub {-pos {-14 -20 0} -box {2 40 6} -color slategray}
    -sub {-pos {14 -20 0} -box {2 40 6} -color slategray}}
shape_set jumper -desc {-sub {-capsule {0.5 1} -color crimson}}
shape_set river -desc {-sub {-box {44 0.6 20} -color steelblue}}
body bridge bridge -fixed 1 -ct 1
body river river -fixed 1 -init_pos {0 -40 0}
body jumper jumper -ct 1 -mass 70
spring rope -body1 jumper -x 0 -y 0 -z 0 -stiffness 120 -rest 12 -pull_only 1
force -body jumper -gravitational {0 -9.81 0}

plot fall -title "Height, and force of the rope over the weight" -values {jumper.y rope.force/686.7} -labels {height force}
view front -rot {0.11 -0.41 -0.02}
