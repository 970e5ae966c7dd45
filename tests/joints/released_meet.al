# Balls on sliders pass through each other, and meet once their slider is released: a and b before they have reached
# each other, c and d, which overlap then, when c has come back from a wall. Those of a link meet, too; e and f, whose
# slider stays, do not.
simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set block -desc {-sub {-box {0.2 1 1}}}
foreach {n x y v} {a 0 0 1   b 1 0 0   c 0 3 1   d 0.5 3 0   e 0 6 1   f 0.5 6 0   g 0 9 1   h 0.6 9 0} {
    body $n ball -init_pos "$x $y 0" -init_dpos "$v 0 0" -mass 1
}
body wall block -init_pos {1.2 3 0} -fixed 1
joint ab -type slider -body1 a -body2 b -axis {1 0 0} -release {t > 0.5}
joint cd -type slider -body1 c -body2 d -axis {1 0 0} -release {t > 0.5}
joint ef -type slider -body1 e -body2 f -axis {1 0 0}
link -body1 g -body2 h -tightness 0 -damping 0 -release {t > 0.2}
