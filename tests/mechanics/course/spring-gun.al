# A spring of 200 N/m, pressed together by 0.1 m, shoots a ball of 0.1 kg straight up: as high as K x^2 / (2 m g) over its start.
simulator -finish 1
shape_set ball -desc {-sub {-sphere 0.03}}
body ball ball -mass 0.1 -init_pos {0 0.2 0}
spring gun -body1 ball -x 0 -y 0 -z 0 -stiffness 200 -rest 0.3 -release {gun.length > 0.3}
force -body ball -gravitational {0 -9.81 0}
