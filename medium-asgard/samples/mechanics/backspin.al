# A ball set down with 2 m/s forwards and a strong backspin of 60 rad/s. Friction slows both down
# evenly until it rolls: backwards, with (5 v - 2 R w) / 7 = -0.286 m/s, from t = 2 (v + R w) / (7 mu g)
# on. Before that it turns round at t = v / (mu g).

parameter spin -value 60 -min 0 -max 80 -label "backspin" -unit rad/s
simulator -finish 3

# The white spots show how it turns.
shape_set ball -desc {-sub {-sphere 0.1 -color crimson}
    -sub {-pos {0.06 0 0.076} -sphere 0.014 -color white} -sub {-pos {-0.06 0 0.076} -sphere 0.014 -color white}}
shape_set cloth -desc {-sub {-box {3.4 0.08 1.2}}} -color seagreen
shape_set rail -desc {-sub {-box {3.4 0.1 0.08}}} -color saddlebrown
body table cloth -fixed 1 -init_pos {0.7 -0.04 0} -friction 0.3
body rail rail -fixed 1 -init_pos {0.7 0.05 -0.56}
body ball ball -shininess 0.9 -mass 0.5 -inertia {0.002 0.002 0.002} -center {0 0 0} -restitution 0 -friction 0.3 -init_pos {0 0.1 0} -init_dpos {2 0 0} \
    -init_drot [list 0 0 $spin]
force -body ball -gravitational {0 -9.81 0}

plot speed -title "Speed and 0.1 m times spin" -values {ball.dx -0.1*ball.wz} -labels {speed rolling}
view side -rot {0.32 0 0}
