# A force that ends, a spring that breaks when it pulls with more than 1, and a link that is cut.
# zero: a.y
simulator -finish 2 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
body a ball -mass 1
force -body a -x 2 -release {t > 0.5}
body b ball -mass 1 -init_pos {1 0 3} -init_dpos {1 0 0}
spring s -body1 b -x 0 -y 0 -z 3 -stiffness 4 -rest 1 -release {s.force > 1}
body c ball -mass 1 -init_pos {0 0 6} -init_dpos {0 1 0}
link -body1 c -x 0 -y 0 -z 6 -tightness 9 -damping 0 -release {c.y > 0.2}
