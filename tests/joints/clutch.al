# A weak motor brings a damped wheel to its speed and holds it there with less than its most (closed form).
# zero: wheel.x
simulator -finish 20
shape_set wheel -desc {-sub {-box {1 1 0.2}}}
body wheel wheel -mass 1 -inertia {2 2 2}
joint axle -type hinge -body1 wheel -speed 10 -max_motor 4 -damping 0.3
