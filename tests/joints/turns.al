# The turns of bodies: a torsion pendulum that goes round several times, and a top that tumbles freely (closed forms).
# zero: wheel.z
simulator -finish 10
shape_set disc -desc {-sub {-box {0.2 0.2 0.1}}}
body wheel disc -mass 1 -inertia {1 1 0.5} -init_drot {0 0 20}
force -body wheel -torque 1 -z {-2*wheel.rz}
body top disc -mass 1 -inertia {1 1 2} -init_pos {5 0 0} -init_drot {1 0 3}
body ball disc -mass 1 -inertia {1 1 1} -init_pos {-5 0 0} -init_drot {0.5 -2 0}
plot turns -values {top.rx top.ry top.rz ball.ry}
