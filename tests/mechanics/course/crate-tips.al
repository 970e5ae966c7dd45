# A lorry brakes with 5 m/s^2, and a crate of 0.5 m by 1.5 m on it tips forwards, for g b / h is only 3.3 m/s^2.
simulator -finish 0.7
shape_set lorry -desc {-sub {-box {12 0.2 2}}}
shape_set crate -desc {-sub {-box {0.5 1.5 0.5}}}
body lorry lorry -mass 5000 -friction 1 -restitution 0 -init_dpos {10 0 0}
joint road -type slider -body1 lorry -axis {1 0 0} -speed {10 - 5*t}
body crate crate -mass 200 -friction 1 -restitution 0 -init_pos {0 0.85 0} -init_dpos {10 0 0}
force -body crate -gravitational {0 -9.81 0}
