# A four-bar linkage: a crank of 0.3 m, a coupler of 1 m and a lever of 0.8 m on pins 0.9 m apart. A motor
# turns the crank with 2 N m against gravity, fast and slow. The answer is an own integration of the angles.

simulator -finish 2.5

shape_set crank -desc {-sub {-box {0.36 0.08 0.04}} -sub {-pos {-0.15 0 0.025} -box {0.03 0.03 0.01} -color white}} -color firebrick
shape_set coupler -desc {-sub {-box {1.06 0.07 0.04}}} -color steelblue
shape_set lever -desc {-sub {-box {0.86 0.08 0.04}}} -color goldenrod
shape_set base -desc {-sub {-pos {0.45 -0.08 -0.09} -box {1.2 0.12 0.06}}} -color slategray
body base base -fixed 1 -ct 1

# Where the coupler and the lever meet: 1 m from the crank's end, 0.8 m from the lever's pin.
set a 0.8
set px [expr {0.3*cos($a)}]
set py [expr {0.3*sin($a)}]
set far [expr {hypot(0.9 - $px, $py)}]
set b [expr {atan2(-$py, 0.9 - $px) + acos((1 + $far*$far - 0.64)/(2*$far))}]
set qx [expr {$px + cos($b)}]
set qy [expr {$py + sin($b)}]
set c [expr {atan2($qy, $qx - 0.9)}]
proc thin {long mass} {
    set a [expr {$mass*(0.05*0.05 + 0.05*0.05)/12}]
    set b [expr {$mass*($long*$long + 0.05*0.05)/12}]
    return [list $a $b $b]
}
body crank crank -ct 1 -mass 0.5 -inertia [thin 0.3 0.5] -center {0 0 0} -init_pos [list [expr {$px/2}] [expr {$py/2}] 0] -init_rot [list 0 0 $a]
body coupler coupler -ct 1 -mass 1 -inertia [thin 1.0 1] -center {0 0 0} \
    -init_pos [list [expr {($px + $qx)/2}] [expr {($py + $qy)/2}] 0] -init_rot [list 0 0 $b]
body lever lever -ct 1 -mass 0.8 -inertia [thin 0.8 0.8] -center {0 0 0} \
    -init_pos [list [expr {(0.9 + $qx)/2}] [expr {$qy/2}] 0] -init_rot [list 0 0 $c]
foreach name {crank coupler lever} {force -body $name -gravitational {0 -9.81 0}}
joint p1 -type hinge -body1 crank -offset1 {-0.15 0 0} -motor 2
joint p2 -type hinge -body1 coupler -offset1 {-0.5 0 0} -body2 crank -offset2 {0.15 0 0}
joint p3 -type hinge -body1 lever -offset1 {0.4 0 0} -body2 coupler -offset2 {0.5 0 0}
joint p4 -type hinge -body1 lever -offset1 {-0.4 0 0} -offset2 {0.9 0 0}

plot rates -title "How fast crank and lever turn" -values {p1.dq p4.dq} -labels {crank lever}
view front -rot {0.19 -0.05 0}
