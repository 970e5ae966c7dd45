# Balls hit a block on its stop, a free one, and one that pulls another along by a taut rope (closed forms).
# zero: stop.q
simulator -finish 2.1
shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}
shape_set bead -desc {-sub {-sphere 0.3}}
body block box -mass 1
joint stop -type slider -body1 block -axis {1 0 0} -limits {-1 0}
body ball bead -mass 1 -init_pos {-2 0 0} -init_dpos {2 0 0}
body free box -mass 1 -init_pos {0 2 0}
joint rail1 -type slider -body1 free -axis {1 0 0} -limits {0 9}
body ball1 bead -mass 1 -init_pos {-2 2 0} -init_dpos {2 0 0}
body first box -mass 1 -init_pos {0 4 0}
body second box -mass 1 -init_pos {-1 6 0}
joint rail2 -type slider -body1 first -axis {1 0 0}
joint rail3 -type slider -body1 second -axis {1 0 0}
rope pulled -points {{first {0 0 0}} {second {0 0 0}}}
body ball2 bead -mass 1 -init_pos {-2 4 0} -init_dpos {2 0 0}
