# A monkey of 9 kg climbs a rope that goes over a wheel; its other end holds 10 kg of bananas, as much as the monkey and its ring, which goes down by as much as the bananas rise.
simulator -finish 3
shape_set thing -desc {-sub {-box {0.2 0.2 0.2}}}
shape_set ring -desc {-sub {-box {0.1 0.1 0.1}}}
body ring ring -mass 1 -init_pos {-0.5 -3 0} -ct 1
body monkey thing -mass 9 -init_pos {-0.5 -3 0} -ct 1
body bananas thing -mass 10 -init_pos {0.5 -3 0}
joint arms -type slider -body1 monkey -body2 ring -axis {0 1 0} -position {t < 2 ? 1.2*(t/2)^2*(3 - t) : 1.2}
joint left -type slider -body1 ring -axis {0 1 0}
rope rope -points {{ring} {-0.5 0 0} {0.5 0 0} {bananas}}
foreach b {ring monkey bananas} {force -body $b -gravitational {0 -9.81 0}}
