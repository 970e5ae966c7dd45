# A ball on a string swings down from level and strikes a block (restitution 0.5), which slides v^2 / (2 mu g) over the floor.
simulator -finish 4
shape_set ground -desc {-sub {-plane}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set block -desc {-sub {-box {0.4 0.3 0.4}}}
body floor ground -fixed 1 -friction 0.3
body ball ball -mass 1 -restitution 0.5 -init_pos {-1.1 1.15 0}
body block block -mass 2 -restitution 0.5 -friction 0.3 -init_pos {0.2 0.15 0}
contact under -body1 block -body2 floor -restitution 0
rope string -points {{-0.1 1.15 0} {ball}}
foreach b {ball block} {force -body $b -gravitational {0 -9.81 0}}
