# zero: -0.29552020666133955*b.x+0.955336489125606*b.y-1.1
simulator -finish 2
shape_set floor -desc {-sub {-box {60 1 4}}}
shape_set ball -desc {-sub {-sphere 0.1}}
shape_set bowl -desc {-sub {-bowl {1 1.1}}}
shape_set hoop -desc {-sub {-rot {1.5707963267948966 0 0} -tube {1 1.1 0.6}}}
shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}
body ground floor -fixed 1 -init_pos {0.14776010333066977 -0.477668244562803 0} -init_rot {0.9887710779360422 0 0 0.14943813247359922} -friction 0.8
body b hoop -init_pos {-0.32507222732747354 1.0508701380381666 0} -restitution 0 -friction 0.8
force -body b -gravitational {0 -9.81 0}
