# The same four-bar turned in space by {0.5 -0.8 0.3}, with all that acts on it (own integration of three angles).
# zero: hypot(crank.px(-0.15,0,0), crank.py(-0.15,0,0), crank.pz(-0.15,0,0))
# zero: hypot(crank.px(0.15,0,0)-rod.px(-0.5,0,0), crank.py(0.15,0,0)-rod.py(-0.5,0,0), crank.pz(0.15,0,0)-rod.pz(-0.5,0,0))
# zero: hypot(rod.px(0.5,0,0)-lever.px(0.4,0,0), rod.py(0.5,0,0)-lever.py(0.4,0,0), rod.pz(0.5,0,0)-lever.pz(0.4,0,0))
simulator -finish 3
shape_set crank -desc {-sub {-box {0.3 0.05 0.05}}}
shape_set rod -desc {-sub {-box {1 0.05 0.05}}}
shape_set lever -desc {-sub {-box {0.8 0.05 0.05}}}
# The rotation R by v = {0.5 -0.8 0.3}: along gives R p, turned the quaternion of R after a turn by a about z.
set v {0.5 -0.8 0.3}
set angle [expr {sqrt(0.25 + 0.64 + 0.09)}]
set w [expr {cos($angle/2)}]
lassign $v x y z
foreach q {x y z} {set $q [expr {[set $q]*sin($angle/2)/$angle}]}
proc along {p} {
    global w x y z
    lassign $p a b c
    set i [expr {2*($y*$c - $z*$b)}]
    set j [expr {2*($z*$a - $x*$c)}]
    set k [expr {2*($x*$b - $y*$a)}]
    return [list [expr {$a + $w*$i + $y*$k - $z*$j}] [expr {$b + $w*$j + $z*$i - $x*$k}] [expr {$c + $w*$k + $x*$j - $y*$i}]]
}
proc turned {a} {
    global w x y z
    set c [expr {cos($a/2)}]
    set s [expr {sin($a/2)}]
    return [list [expr {$w*$c - $z*$s}] [expr {$x*$c + $y*$s}] [expr {$y*$c - $x*$s}] [expr {$z*$c + $w*$s}]]
}
# The pin between rod and lever: 1 from the crank's end, 0.8 from the lever's pivot at 0.9.
set a 0.8
set px [expr {0.3*cos($a)}]
set py [expr {0.3*sin($a)}]
set far [expr {hypot(0.9 - $px, $py)}]
set b [expr {atan2(-$py, 0.9 - $px) + acos((1 + $far*$far - 0.64)/(2*$far))}]
set qx [expr {$px + cos($b)}]
set qy [expr {$py + sin($b)}]
set c [expr {atan2($qy, $qx - 0.9)}]
body crank crank -mass 0.5 -init_pos [along [list [expr {$px/2}] [expr {$py/2}] 0]] -init_rot [turned $a]
body rod rod -mass 1 -init_pos [along [list [expr {($px + $qx)/2}] [expr {($py + $qy)/2}] 0]] -init_rot [turned $b]
body lever lever -mass 0.8 -init_pos [along [list [expr {(0.9 + $qx)/2}] [expr {$qy/2}] 0]] -init_rot [turned $c]
foreach name {crank rod lever} {force -body $name -gravitational [along {0 -9.81 0}]}
joint p1 -type hinge -body1 crank -offset1 {-0.15 0 0} -motor 2
joint p2 -type hinge -body1 rod -offset1 {-0.5 0 0} -body2 crank -offset2 {0.15 0 0}
joint p3 -type hinge -body1 lever -offset1 {0.4 0 0} -body2 rod -offset2 {0.5 0 0}
joint p4 -type hinge -body1 lever -offset1 {-0.4 0 0} -offset2 [along {0.9 0 0}]
