# A yo-yo of 0.2 kg unrolls from its thread: R = 1 cm where the thread is wound, I = 0.00008 kg m^2. It
# falls with a = g / (1 + I/(m R^2)) = 1.962 m/s^2, a fifth of g, and the thread bears 4/5 of its weight.

simulator -finish 0.9

set axle 0.01
shape_set yo-yo -desc {
    -sub {-pos {0 0 0.016} -rot {1.5707963267948966 0 0} -cylinder {0.04 0.02} -color crimson}
    -sub {-pos {0 0 -0.016} -rot {1.5707963267948966 0 0} -cylinder {0.04 0.02} -color crimson}
    -sub {-rot {1.5707963267948966 0 0} -cylinder {0.01 0.012} -color ivory}
    -sub {-pos {0.025 0 0.028} -sphere 0.005 -color gold} -sub {-pos {-0.025 0 0.028} -sphere 0.005 -color gold}
}
shape_set hand -desc {-sub {-box {0.08 0.03 0.06} -color burlywood}}
shape_set wall -desc {-sub {-box {0.6 1.1 0.02} -color lightsteelblue}}
body hand hand -fixed 1 -init_pos {0 0.015 0}
body wall wall -fixed 1 -init_pos {0 -0.45 -0.1}
body yoyo yo-yo -mass 0.2 -inertia {0.00006 0.00006 0.00008} -center {0 0 0} -init_pos [list $axle -0.1 0]
rope thread -points [list {0 0 0} [list yoyo {0 0 0} $axle]]
force -body yoyo -gravitational {0 -9.81 0}

plot tension -title "Tension of the thread over the weight" -values {thread.tension/(yoyo.mass*9.81)} -labels {thread}
view front -rot {0.05 -0.14 0}
