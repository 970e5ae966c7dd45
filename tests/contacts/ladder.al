# zero: l.y-0.943112822219165
simulator -finish 5
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
body ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5 
shape_set ladder -desc {-sub {-box {2 0.02 0.4}}}
shape_set wall -desc {-sub {-box {1 8 4}}}
body wall wall -fixed 1 -init_pos {0.5 4 0}
body l ladder -mass 2 -restitution 0 -friction 0.5 -init_pos {-0.3514170695335279 0.943112822219165 0} -init_rot {0 0 1.2217304763960306}
force -body l -gravitational {0 -9.81 0}
contact below -body1 l -body2 ground
contact beside -body1 wall -body2 l
