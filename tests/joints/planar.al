# A slab is thrown and turns on a plane inclined by 0.3 (closed form).
# zero: -sin(0.3)*slab.x + cos(0.3)*slab.y
simulator -finish 2
shape_set slab -desc {-sub {-box {0.6 0.2 0.4}}}
body slab slab -mass 2 -init_rot {0 0 0.3} -init_dpos [list [expr {2*cos(0.3)}] [expr {2*sin(0.3)}] 0.5] \
    -init_drot [list [expr {-3*sin(0.3)}] [expr {3*cos(0.3)}] 0]
force -body slab -gravitational {0 -9.81 0}
joint table -type planar -body1 slab -offset1 {0.2 -0.1 0} -axis {0 1 0}
