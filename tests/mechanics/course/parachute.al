# A jumper falls against the square of his speed, and opens his parachute after 8 s: 56 m/s, and soon 5.6 m/s.
simulator -finish 14
shape_set jumper -desc {-sub {-sphere 0.5}}
body jumper jumper -mass 80
force -body jumper -gravitational {0 -9.81 0}
force -body jumper -y {-(t < 8 ? 0.25 : 25)*jumper.dy*abs(jumper.dy)}
