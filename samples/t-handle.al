# A union of shapes: a handle with a crossbar spins, weightless, about the axis of its middle moment of
# inertia. It turns over, again and again (the Dzhanibekov effect): spinning about that axis is not
# stable, and rigid bodies obey Euler's equations.

simulator -finish 20 -collisions 0

shape_set handle -desc {
    -sub {-pos {0 0 0} -box {2.4 0.35 0.35} -color goldenrod}
    -sub {-pos {0 0.75 0} -box {0.3 1.15 0.3} -color darkgoldenrod}
    -sub {-pos {-1.48 0 0} -sphere 0.28 -color firebrick}
    -sub {-pos {1.48 0 0} -sphere 0.28 -color firebrick}
}

# The stem is the axis: of the three moments the middle one.
body tool handle -init_drot {0.01 5 0}

view front -rot {0.13 0 0}
