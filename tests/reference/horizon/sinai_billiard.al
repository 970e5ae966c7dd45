# The Sinai billiard of d13, for so long that rounding wins: a ball of radius 0.25 in the square |x|, |y| < 2
# with a fixed ball of radius 1 in its middle.
simulator -start 0 -finish 100

shape_set ball -desc {-sub {-sphere 0.25}}
shape_set disc -desc {-sub {-sphere 1}}
shape_set upright -desc {-sub {-box {1 6 4}}}
shape_set level -desc {-sub {-box {6 1 4}}}

body A ball -mass 1 -init_pos {-1.5 0.375 0} -init_dpos {0.8125 0.5 0}
body disc disc -fixed 1 -init_pos {0 0 0}
body left upright -fixed 1 -init_pos {-2.5 0 0}
body right upright -fixed 1 -init_pos {2.5 0 0}
body below level -fixed 1 -init_pos {0 -2.5 0}
body above level -fixed 1 -init_pos {0 2.5 0}
