# A coin rolls on its rim in a circle of 0.4 m and leans inwards by 0.3 rad. It neither falls nor slips, for
# it goes round at just W = 2.0402 rad/s: there its spin and weight agree (Euler's equations in steady motion).

simulator -finish 4

set a 0.3          ;# how it leans
set r 0.1          ;# its radius
set h 0.01         ;# its thickness
set circle 0.4     ;# of its centre
set m 0.2
set about [expr {$m*$r*$r/2}]
set across [expr {$m*(3*$r*$r + $h*$h)/12}]
# The lowest point of its rim, seen from its centre: c outwards, high below.
set c [expr {$r*sin($a) - $h/2*cos($a)}]
set high [expr {$r*cos($a) + $h/2*sin($a)}]
set W [expr {sqrt($c*$m*9.81/(($across - $about)*sin($a)*cos($a) + $about*cos($a)*($circle + $c)/$r + $high*$m*$circle))}]
set spin [expr {-$W*($circle + $c)/$r}]

shape_set coin -desc "-sub {-cylinder {$r $h} -color goldenrod}"
shape_set table -desc {-sub {-cylinder {0.8 0.05} -color saddlebrown}}
body table table -fixed 1 -friction 0.8 -init_pos {0 -0.025 0}
body coin coin -mass $m -inertia [list $across $about $across] -center {0 0 0} -restitution 0 -friction 0.8 \
    -init_pos [list $circle $high 0] -init_rot [list 0 0 [expr {$a - acos(-1)/2}]] \
    -init_dpos [list 0 0 [expr {-$W*$circle}]] -init_drot [list [expr {$spin*cos($a)}] [expr {$W + $spin*sin($a)}] 0]
force -body coin -gravitational {0 -9.81 0}
view corner -rot {0.52 0 0}
