# A lamp of 10 kg hangs over a street by two ropes that rise at 30 and 45 degrees: what does each bear?
simulator -finish 10
shape_set lamp -desc {-sub {-sphere 0.2}}
body lamp lamp -mass 10
rope left -points {{-3.4641016151377544 2 0} {lamp}}
rope right -points {{2 2 0} {lamp}}
force -body lamp -gravitational {0 -9.81 0}
