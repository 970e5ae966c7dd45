# A lorry passes with 10 m/s as a car starts with 2 m/s^2: the car is beside it after 10 s and 100 m.
simulator -finish 12
shape_set car -desc {-sub {-box {4 1.4 1.8}}}
body lorry car -mass 8000 -init_pos {0 0 3} -init_dpos {10 0 0}
body car car -mass 1000
force -body car -x 2000
