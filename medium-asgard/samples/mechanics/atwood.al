# Atwood's machine: 1.2 kg and 1 kg hang on a thread over a wheel of 0.5 kg. The heavy one sinks with
# a = (M - m) g / (M + m + I/R^2) = 0.8008 m/s^2, for the wheel counts half its mass (I = 0.25 R^2).

parameter heavy -value 1.2 -min 1 -max 2 -label "the heavy one" -unit kg
simulator -finish 1.5

shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.15 0.05} -color steelblue}
    -sub {-pos {0.09 0 0.03} -sphere 0.018 -color white} -sub {-pos {-0.09 0 0.03} -sphere 0.018 -color white}}
shape_set weight -desc {-sub {-cylinder {0.06 0.14} -color goldenrod} -sub {-pos {0 0.085 0} -cylinder {0.012 0.03} -color gray}}
shape_set small -desc {-sub {-cylinder {0.055 0.12} -color firebrick} -sub {-pos {0 0.075 0} -cylinder {0.012 0.03} -color gray}}
shape_set stand -desc {-sub {-pos {0 0.55 -0.12} -box {0.06 2.3 0.06} -color slategray}
    -sub {-pos {0 -0.62 -0.1} -box {0.9 0.04 0.5} -color slategray} -sub {-pos {0 1.5 -0.05} -cylinder {0.02 0.02} -color gray}
    -sub {-pos {0 1.5 -0.06} -rot {1.5707963267948966 0 0} -cylinder {0.02 0.1} -color gray}}

body stand stand -fixed 1 -ct 1
body wheel wheel -mass 0.5 -inertia {0.003 0.003 0.005625} -center {0 0 0} -init_pos {0 1.5 0} -ct 1
body down weight -mass $heavy -init_pos {-0.15 0.9 0}
body up small -mass 1 -init_pos {0.15 0 0}
joint axle -type hinge -body1 wheel -offset1 {0 0 0}
rope thread -points {{down {0 0.1 0}} {wheel {0 0 0} 0.15} {up {0 0.09 0}}}
force -body down -gravitational {0 -9.81 0}
force -body up -gravitational {0 -9.81 0}

plot tension -title "Tension on both sides" -values {thread.tension1 thread.tension2} -labels {heavy light}
view front -rot {0.1 -0.15 -0.01}
