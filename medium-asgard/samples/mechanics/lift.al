# A man of 80 kg in a lift stands on scales. They show more than his weight while the lift gains speed, his
# weight while it goes evenly, and less while it slows down: N = m (g + a) with a = 1, 0 and -1 m/s^2.

simulator -finish 6

shape_set cabin -desc {-sub {-pos {0 -0.05 0} -box {1.6 0.1 1.4} -color slategray} -sub {-pos {0 2.45 0} -box {1.6 0.1 1.4} -color slategray}
    -sub {-pos {0 1.2 -0.68} -box {1.6 2.4 0.04} -color lightsteelblue}}
shape_set man -desc {-sub {-pos {0 -0.26 0} -box {0.34 1.08 0.24} -color royalblue} -sub {-pos {0 0.48 0} -box {0.46 0.4 0.26} -color firebrick}
    -sub {-pos {0 0.8 0} -sphere 0.12 -color burlywood}}
shape_set rail -desc {-sub {-box {0.06 13 0.06} -color dimgray}}
body left rail -fixed 1 -ct 1 -init_pos {-0.85 5.5 -0.5}
body right rail -fixed 1 -ct 1 -init_pos {0.85 5.5 -0.5}
body cabin cabin -mass 400 -ct 1
joint shaft -type slider -body1 cabin -axis {0 1 0} -speed {t < 2 ? t : t < 4 ? 2 : 6 - t}
body man man -mass 80 -restitution 0 -friction 0.6 -init_pos {0 0.8 0}
contact scales -body1 man -body2 cabin
foreach body {cabin man} {force -body $body -gravitational {0 -9.81 0}}

plot weight -title "What the scales show, in kg" -values {scales.n/9.81} -labels {kg}
view side -rot {0.09 -0.23 -0.01}
