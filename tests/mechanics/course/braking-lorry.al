# A lorry brakes from 10 m/s with 4 m/s^2, and the crate on it slides on (friction 0.3): it stops later and 4.5 m farther on the platform.
simulator -finish 4
shape_set lorry -desc {-sub {-box {12 0.2 2}}}
shape_set crate -desc {-sub {-box {1 0.6 1}}}
body lorry lorry -mass 5000 -friction 0.3 -restitution 0 -init_dpos {10 0 0}
joint road -type slider -body1 lorry -axis {1 0 0} -speed {max(0, 10 - 4*t)}
body crate crate -mass 200 -friction 0.3 -restitution 0 -init_pos {-4 0.4 0} -init_dpos {10 0 0}
force -body crate -gravitational {0 -9.81 0}
