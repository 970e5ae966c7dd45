# A clock: a weight turns a wheel of twelve pins, two pallets on the pendulum stop it, and each swing lets half a
# tooth go by. A pin that slides off the slope of a pallet pushes the pendulum on: m g r pi/12 = 1.64 mJ for each swing,
# less what the blows take. So the pendulum swings on, though its hinge takes energy all the time.

simulator -finish 6

set pi [expr {acos(-1)}]
set quarter [expr {$pi/2}]
set pins 12
set radius 0.1
set pin 0.002
set half [expr {2.5*$pi/$pins}]
set high [expr {$radius/cos($half)}]
set far [expr {$radius*tan($half)}]

# A disc, its drum, and pins with round heads.
set wheel "-sub {-pos {0 0 -0.02} -rot {$quarter 0 0} -cylinder {0.106 0.006} -color goldenrod} -sub {-pos {0 0 -0.03} -rot {$quarter 0 0} -cylinder {0.008 0.014} -color saddlebrown}"
for {set k 0} {$k < $pins} {incr k} {
    set a [expr {$quarter + $half + 2*$pi*$k/$pins}]
    append wheel " -sub {-pos {[expr {$radius*cos($a)}] [expr {$radius*sin($a)}] -0.0125} -rot {$quarter 0 0} -cylinder {0.0015 0.009} -color silver} -sub {-pos {[expr {$radius*cos($a)}] [expr {$radius*sin($a)}] 0} -sphere $pin -color silver}"
}
shape_set wheel -desc $wheel
body wheel wheel -mass 0.02 -center {0 0 0} -inertia {3e-5 3e-5 5e-5} -restitution 0 -init_rot {0 0 0.02}
joint arbor -type hinge -body1 wheel -offset1 {0 0 0}

# Corners of a pallet: how far they are from the pivot, and how deep in the wheel.
proc pallet {side corners} {
    global half
    set points {}
    foreach {away deep} $corners {
        set place "[expr {$side*($away*cos($half) - $deep*sin($half))}] [expr {-$away*sin($half) - $deep*cos($half)}]"
        lappend points "{$place -0.006}" "{$place 0.026}"
    }
    return "-sub {-points {[join $points]} -color firebrick}"
}
set near [expr {$far - $pin}]
set beyond [expr {$far + $pin}]
set pendulum [pallet -1 [list $near -0.0012 [expr {$near-0.018}] 0.0026 [expr {$near-0.018}] -0.012 $near -0.012]]
append pendulum " " [pallet 1 [list $beyond -0.0012 [expr {$beyond+0.018}] 0.0026 [expr {$beyond+0.018}] -0.012 $beyond -0.012]]
append pendulum " -sub {-pos {-0.035 -0.03 0.023} -rot {0 0 0.6545} -box {0.1 0.012 0.006} -color gray} -sub {-pos {0.035 -0.03 0.023} -rot {0 0 -0.6545} -box {0.1 0.012 0.006} -color gray}"
append pendulum " -sub {-pos {0 -0.14 0.03} -box {0.008 0.28 0.006} -color gray} -sub {-pos {0 -0.28 0.03} -rot {$quarter 0 0} -cylinder {0.05 0.02} -color gold}"
shape_set pendulum -desc $pendulum
body pendulum pendulum -mass 1 -center {0 -0.22 0} -inertia {0.006 0.006 0.00627} -restitution 0 -init_pos [list 0 $high 0] -init_rot {0 0 0.08}
joint pivot -type hinge -body1 pendulum -offset1 {0 0 0} -damping 0.01

shape_set weight -desc {-sub {-cylinder {0.015 0.05} -color slategray}}
body weight weight -mass 0.08 -init_pos {0.008 -0.15 0}
rope cord -points {{wheel {0 0 0} -0.008} {weight {0 0.025 0}}}
contact -body1 weight -body2 pendulum -collide 0
contact -body1 weight -body2 wheel -collide 0
foreach b {pendulum weight} {force -body $b -gravitational {0 -9.81 0}}

plot swing -title "Swing of the pendulum, and turn of the wheel in teeth" -values {pivot.q*180/pi+4.584 -arbor.q*6/pi} -labels {° teeth}
view front -rot {0.06 -0.3 0}
