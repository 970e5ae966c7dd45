parameter n -value 3
proc arm {i} {body b$i s -init_pos [list $i 0 0]}
for {set i 0} {$i < $n} {incr i} {
  arm $i ;# one
}
shape_set s -desc {-sub {-box {1 2 3}}}
