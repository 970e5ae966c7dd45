# A weight of 0.5 kg on a thread turns a wheel, round whose drum of 5 cm the thread is wound: a = m g / (m + I / r^2).
simulator -finish 2
shape_set wheel -desc {-sub {-rot {1.5708 0 0} -cylinder {0.2 0.05}}}
shape_set weight -desc {-sub {-cylinder {0.04 0.1}}}
body wheel wheel -mass 2 -inertia {0.03 0.03 0.04}
joint axle -type hinge -body1 wheel
body weight weight -mass 0.5 -init_pos {0.05 -0.5 0} -ct 1
rope thread -points {{wheel {0 0 0} -0.05} {weight {0 0.05 0}}}
force -body weight -gravitational {0 -9.81 0}
