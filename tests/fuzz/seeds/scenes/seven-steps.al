# What the seven steps of the dissertation's section 3.2 make: a pendulum of two parts swings down and
# strikes a cube that drifts across its way, unaffected by any force.

# 1. The basic shapes.
shape_set rod -desc {-sub {-box {10 1.1 1.1}}} -color steelblue
shape_set cube -desc {-sub {-box {1 1 1}}} -color goldenrod

# 2. The objects. 3. What the language viewer adds: the articulated body, masses.
body rod1 rod -init_pos {-5 0 0} -artbody pendulum -mass 10
body rod2 rod -init_pos {-15 0 0} -artbody pendulum -mass 10 -color lightsteelblue
body cube1 cube -init_pos {10.1 -17 0} -init_dpos {-3 0 0}

# 4. Gravity.
force -body rod1 -gravitational {0 -10 0}
force -body rod2 -gravitational {0 -10 0}

# 5. The links: the upper rod hangs on the origin, the lower one on the upper.
link -body1 rod1 -offset1 {5 0 0} -x 0 -y 0 -z 0 -tightness 5000
link -body1 rod2 -offset1 {5 0 0} -body2 rod1 -offset2 {-5 0 0} -tightness 5000

# 6. The time range. (7. Play.)
simulator -finish 5 -step 0.1
