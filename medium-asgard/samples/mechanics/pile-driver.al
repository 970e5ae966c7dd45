# A hammer of 600 kg falls 2 m onto a pile of 300 kg, and both go on together: two thirds of its speed are
# left. Dry friction of 60 kN in the ground stops them: depth = v^2 / (2 a), a = F/(M + m) - g, or 15.3 cm.

simulator -finish 1.4

shape_set hammer -desc {-sub {-box {0.7 0.6 0.6} -color slategray}}
shape_set pile -desc {-sub {-box {0.3 3 0.3} -color peru}}
shape_set ground -desc {-sub {-pos {-1.15 -0.5 0} -box {2 1 2} -color darkolivegreen} -sub {-pos {1.15 -0.5 0} -box {2 1 2} -color darkolivegreen}}
shape_set mast -desc {-sub {-box {0.16 5 0.16} -color goldenrod} -sub {-pos {0.45 2.4 0} -box {0.9 0.16 0.16} -color goldenrod}}
body ground ground -fixed 1 -ct 1 -init_pos {0 -0.9 0}
body mast mast -fixed 1 -ct 1 -init_pos {-0.55 2.1 -0.2}
body pile pile -mass 300 -restitution 0
body hammer hammer -mass 600 -restitution 0 -init_pos {0 3.8 0}
joint rail -type slider -body1 hammer -axis {0 1 0}
joint soil -type slider -body1 pile -axis {0 1 0} -friction 60000
foreach body {hammer pile} {force -body $body -gravitational {0 -9.81 0}}

plot depth -title "How deep the pile has gone, in cm" -values {-100*soil.q} -labels {cm}
view front -rot {0.11 -0.21 -0.01}
