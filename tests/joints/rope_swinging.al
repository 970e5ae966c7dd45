# Atwood's machine over two points without friction; one mass swings (own integration).
# zero: r.length-5
simulator -finish 4 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body big ball -mass 3 -init_pos {-1 -3 0}
body m ball -mass 1 -init_pos {1 0 0}
force -body big -gravitational {0 -9.81 0}
force -body m -gravitational {0 -9.81 0}
rope r -points {{big {0 0 0}} {-1 0 0} {0 0 0} {m {0 0 0}}}
