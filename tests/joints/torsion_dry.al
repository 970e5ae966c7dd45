# A torsion pendulum with a dry couple rests after eight half swings (closed form).
# zero: wheel.x
simulator -finish 15
shape_set wheel -desc {-sub {-box {1 1 0.2}}}
body wheel wheel -mass 1 -inertia {1 1 1}
joint wire -type hinge -body1 wheel -stiffness 4 -rest -2.1 -friction 0.5
