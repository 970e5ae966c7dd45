# A block on a belt, held by a spring: it rides along until the spring draws it off, slides back, is caught again. So a bow moves a string.
simulator -finish 3
shape_set ground -desc {-sub {-plane}}
shape_set block -desc {-sub {-box {0.2 0.1 0.2}}}
body belt ground -fixed 1 -surface_velocity {0.2 0 0} -friction 0.4 -static_friction 0.6
body block block -mass 1 -restitution 0 -friction 0.4 -static_friction 0.6 -init_pos {0 0.05 0} -init_dpos {0.2 0 0}
contact rub -body1 block -body2 belt
spring string -body1 block -x -1 -y 0.05 -z 0 -stiffness 100
force -body block -gravitational {0 -9.81 0}
