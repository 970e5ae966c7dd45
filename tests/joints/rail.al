# A block on a rail with dry friction between stops, pushed to and fro: it sticks, slips, reverses, hits (closed form between).
# zero: block.y
simulator -finish 10
shape_set block -desc {-sub {-box {0.1 0.1 0.1}}}
body block block -mass 1
force -body block -x {4*sin(t)} -y 0 -z 0
joint rail -type slider -body1 block -axis {1 0 0} -friction 2 -limits {-0.5 0.8} -limit_restitution 0.3
