# A double pendulum of two rods of 0.5 m, let go level. Nobody foresees it for long: for three seconds the
# answer of an own integration of the two angles is right to nine digits, for forty no digit would be.

simulator -finish 3

shape_set upper -desc {-sub {-box {0.5 0.05 0.04}}} -color steelblue
shape_set lower -desc {-sub {-pos {0 0 0.045} -box {0.5 0.04 0.04}}} -color darkorange
shape_set stand -desc {-sub {-pos {0 -0.1 -0.08} -box {0.08 0.6 0.06}}} -color slategray
body stand stand -fixed 1 -ct 1
body upper upper -ct 1 -mass 1 -inertia {0.001 0.021 0.021} -center {0 0 0} -init_pos {0.25 0 0}
body lower lower -ct 1 -mass 0.8 -inertia {0.001 0.017 0.017} -center {0 0 0} -init_pos {0.75 0 0}
foreach name {upper lower} {force -body $name -gravitational {0 -9.81 0}}
joint first -type hinge -body1 upper -offset1 {-0.25 0 0}
joint second -type hinge -body1 lower -offset1 {-0.25 0 0} -body2 upper -offset2 {0.25 0 0}

plot angles -title "Angles" -values {first.q second.q} -labels {first second}
view front -rot {0.09 -0.1 0}
