# A lorry starts with 1.5 m/s^2, and a log that lies across its platform rolls: it gains a third of that.
simulator -finish 2
shape_set lorry -desc {-sub {-box {8 0.2 2}}}
shape_set log -desc {-sub {-rot {1.5708 0 0} -cylinder {0.3 1.6}}}
body lorry lorry -mass 5000 -friction 0.5 -restitution 0
joint road -type slider -body1 lorry -axis {1 0 0} -speed {1.5*t}
body log log -mass 100 -friction 0.5 -restitution 0 -init_pos {2 0.4 0}
force -body log -gravitational {0 -9.81 0}
