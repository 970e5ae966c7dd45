# Two boxes of 5 kg are pushed at their tops, harder and harder (F = 8 N/s t). The tall one tips when
# F h = m g w/2, at t = 1.839 s, before it can slide; the low one, which is waxed, slides when
# F = mu m g with mu = 0.25, at t = 1.533 s.

simulator -finish 2.4

shape_set tall -desc {-sub {-box {0.3 0.5 0.3} -color firebrick}}
shape_set low -desc {-sub {-box {0.5 0.2 0.3} -color steelblue}}
shape_set floor -desc {-sub {-box {2.6 0.06 1.6} -color burlywood}}
body floor floor -fixed 1 -init_pos {0.3 -0.03 0} -friction 0.5
body tall tall -mass 5 -restitution 0 -friction 0.5 -init_pos {0 0.25 0.35}
body low low -mass 5 -restitution 0 -friction 0.5 -init_pos {0 0.1 -0.35}
contact -body1 low -body2 floor -friction 0.25
foreach {name high} {tall 0.25 low 0.1} {
    force -body $name -gravitational {0 -9.81 0}
    force -body $name -offset [list 0 $high 0] -x {8*t} -y 0 -z 0
}
view corner -rot {0.3 -0.3 -0.05}
