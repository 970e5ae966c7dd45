# The cue ball strikes two touching balls between them, both at the same instant. Without friction they go
# off at 30 degrees with 2 sqrt(3) v / 5 each, and the cue ball comes back with v / 5.

simulator -finish 1.5

shape_set ball -desc {-sub {-sphere 0.05}} -shininess 0.9
shape_set table -desc {-sub {-pos {0 -0.09 0} -box {2.6 0.06 1.4} -color seagreen} -sub {-pos {1.35 -0.05 0} -box {0.1 0.14 1.6} -color saddlebrown}
    -sub {-pos {-1.35 -0.05 0} -box {0.1 0.14 1.6} -color saddlebrown} -sub {-pos {0 -0.05 -0.75} -box {2.6 0.14 0.1} -color saddlebrown}
    -sub {-pos {0 -0.05 0.75} -box {2.6 0.14 0.1} -color saddlebrown}}
body table table -fixed 1
body red ball -mass 0.17 -init_pos {0 0 -0.05} -color crimson
body blue ball -mass 0.17 -init_pos {0 0 0.05} -color royalblue
body cue ball -mass 0.17 -init_pos {-0.8 0 0} -init_dpos {1.5 0 0} -color ivory
view above -rot {0.7 0 0}
