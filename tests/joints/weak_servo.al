# A place that is held by a motor too weak for it: it slips, and holds the rest of the way from where they agree again.
# zero: a.y
simulator -finish 6.1
shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}
body a box -mass 1 -init_dpos {1 0 0}
joint rail -type slider -body1 a -axis {1 0 0} -position {sin(t)} -max_motor 0.5
