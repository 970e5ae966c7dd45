# Coordinates that begin at -from: springs of a hinge and a rail, a gear, a screw, a limit, a plane, a cross and a drive (closed forms).
# zero: hypot(wheel.x, wheel.y, wheel.z)
# zero: one.y - 2
# zero: hypot(flat.z, cross.y - 5)
simulator -finish 3
shape_set s -desc {-sub {-box {0.4 0.4 0.4}}}
proc cube {name x y args} {body $name s -mass 2 -inertia {0.1 0.1 0.1} -init_pos "$x $y 0" -ct 1 {*}$args}
cube wheel 0 0
joint pin -type hinge -body1 wheel -stiffness 0.4 -rest 0.2 -from 0.5
cube block 3 0
joint rail -type slider -body1 block -axis {1 0 0} -stiffness 8 -rest -0.1 -from 0.3
cube one 0 2 -init_drot {0 0 1}
cube two 2 2 -init_drot {0 0 -0.5}
joint first -type hinge -body1 one -from 7
joint second -type hinge -body1 two -from -1
gear mesh -joint1 first -joint2 second -ratio -2
cube nut 0 3 -init_drot {2 0 0} -init_dpos [list [expr {0.5 / acos(-1)}] 0 0]
joint thread -type screw -body1 nut -axis {1 0 0} -pitch 0.5 -from 1
cube ring 0 4 -init_drot {3 0 0} -init_dpos {0.7 0 0}
joint sleeve -type cylindrical -body1 ring -axis {1 0 0} -from1 0.4 -from2 -0.2 -limits2 {-0.5 1.2}
cube flat 3 3 -init_drot {0 0 1} -init_dpos {0.3 -0.2 0}
joint table -type planar -body1 flat -from1 1 -from2 2 -from3 3
cube cross 0 5 -init_drot {2 0 0}
joint hooke -type universal -body1 cross -axis {1 0 0} -axis2 {0 1 0} -from1 0.1 -from2 0.2
cube arm 3 5 -init_drot {0 0 2}
joint lift -type hinge -body1 arm -position {0.5 + sin(2 * t)} -from 0.5 -limits {-1 2}
