# Double pendulum of two equal point masses on massless rods of 1 m, released from 120 and 170 degrees, as
# equations in its two angles: upper.x and lower.x are the angles in rad, from hanging down.
simulator -start 0 -finish 40 -collisions 0

shape_set ball -desc {-sub {-sphere 0.1}}
body upper ball -mass 1 -init_pos {2.0943951023931953 0 0}
body lower ball -mass 1 -init_pos {2.9670597283903604 0 1}

force -body upper -x {(-29.43*sin(upper.x) - 9.81*sin(upper.x-2*lower.x) - 2*sin(upper.x-lower.x)*(lower.dx^2+upper.dx^2*cos(upper.x-lower.x)))/(3-cos(2*upper.x-2*lower.x))} -y 0 -z 0
force -body lower -x {2*sin(upper.x-lower.x)*(2*upper.dx^2+19.62*cos(upper.x)+lower.dx^2*cos(upper.x-lower.x))/(3-cos(2*upper.x-2*lower.x))} -y 0 -z 0
