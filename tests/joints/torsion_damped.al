# A torsion pendulum with damping and a motor of cos 3t (closed form).
# zero: wheel.x
simulator -finish 6
shape_set wheel -desc {-sub {-box {1 1 0.2}}}
body wheel wheel -mass 1 -inertia {2 2 2} -init_drot {0 0 1.5}
joint wire -type hinge -body1 wheel -stiffness 8 -damping 0.6 -motor {cos(3*t)}
