# A pressed spring pushes carts of 1 kg and 2 kg apart and falls off at its own length: their speeds are as 2 to 1.
simulator -finish 1
shape_set cart -desc {-sub {-box {0.1 0.1 0.1}}}
body light cart -mass 1 -init_pos {-0.1 0 0}
body heavy cart -mass 2 -init_pos {0.1 0 0}
spring between -body1 light -body2 heavy -stiffness 300 -rest 0.4 -release {between.length > 0.4}
