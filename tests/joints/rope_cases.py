"""The values of scenes with ropes: rows of time, expression, value, scale. Letters as in the scenes; SI units."""
import math

from cases import G, Rows, steps
from integration import solve


def first(low, high, ended):
    """The time between both at which ended(t) becomes true."""
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if ended(middle) else (middle, high)
    return high


def rope_drop():
    """From the point where the rope is tied: free fall, then hops that halve their speed, and hangs from 3 sqrt(2 / g) on."""
    rows, begin, y, v = Rows(), 0.0, 0.0, 0.0
    fall = math.sqrt(2 / G)
    parts = [(0.0, 0.0, 0.0)]
    begin, v = fall, math.sqrt(2 * G) / 2
    for _ in range(60):
        parts.append((begin, -1.0, v))
        begin, v = begin + 2 * v / G, v / 2
    for t in [0.2, 0.4, 0.5, 0.8, 0.9, 1.0, 1.2, 1.3, 1.36, 2, 3]:
        if t > 3 * fall:
            rows.put(t, 5, {"b.y": -1, "b.dy": 0, "r.length": 1})
            rows.put(t, 40, {"r.tension": 2 * G})
            continue
        start, y, v = [part for part in parts if part[0] < t][-1]
        s = t - start
        rows.put(t, 5, {"b.y": y + v * s - G * s * s / 2, "r.length": abs(y + v * s - G * s * s / 2)})
        if abs(t - 1.36) > 0.01:
            rows.put(t, 50, {"b.dy": v - G * s})
        rows.put(t, 40, {"r.tension": 0})
    return rows


def rope_slack():
    """a'' = -g sin a while v^2 + g cos a > 0; then a parabola up to the circle, where the radial velocity ends."""
    rows, at = Rows(), [0.1, 0.3, 0.45, 0.6, 0.8, 1.0, 1.1, 1.3, 1.6, 2.0, 2.5, 3.0]

    def swings(_, y):
        return [y[1], -G * math.sin(y[0])]

    def tension(y):
        return y[1] ** 2 + G * math.cos(y[0])

    t, y, parts = 0.0, [0.0, 5.6], []
    while t < max(at):
        begin, end = t, t
        while end < max(at) and tension(solve(swings, y, [end + 0.02], start=t)[0]) > 0:
            end += 0.02
        parts.append((t, "swings", y))
        if end >= max(at):
            break
        end = first(end, end + 0.02, lambda u: tension(solve(swings, y, [u], start=begin)[0]) <= 0)
        a, w = solve(swings, y, [end], start=t)[0]
        flight = [math.sin(a), -math.cos(a), w * math.cos(a), w * math.sin(a)]
        parts.append((end, "flies", flight))

        def out(u):
            s = u - end
            return math.hypot(flight[0] + flight[2] * s, flight[1] + flight[3] * s - G * s * s / 2)

        t = end + 0.05
        while out(t) < 1:
            t += 0.01
        t = first(t - 0.01, t, lambda u: out(u) >= 1)
        s = t - end
        x, z = flight[0] + flight[2] * s, flight[1] + flight[3] * s - G * s * s / 2
        a = math.atan2(x, -z)
        y = [a, flight[2] * math.cos(a) + (flight[3] - G * s) * math.sin(a)]
    for time in at:
        begin, kind, state = [part for part in parts if part[0] < time][-1]
        if kind == "swings":
            a, w = solve(swings, state, [time], start=begin)[0]
            rows.put(time, 5, {"b.x": math.sin(a), "b.y": -math.cos(a), "r.length": 1})
            rows.put(time, 400, {"r.tension": 2 * tension([a, w])})
        else:
            s = time - begin
            x, z = state[0] + state[2] * s, state[1] + state[3] * s - G * s * s / 2
            rows.put(time, 5, {"b.x": x, "b.y": z, "r.length": math.hypot(x, z)})
            rows.put(time, 400, {"r.tension": 0})
    return rows


def rope_light_wheel():
    """Over a wheel of a hundred thousandth of the weights the tensions are as without one."""
    rows, wheel = Rows(), 1e-5
    a = G / (3 + wheel / 2)
    for t in steps(0.6, 3):
        rows.put(t, 2, {"a.y": a * t * t / 2, "b.y": -a * t * t / 2})
        rows.put(t, 20, {"w.wz": -a * t / 0.1})
        rows.put(t, 40, {"line.tension1": G + a, "line.tension2": 2 * (G - a)})
    return rows


def rope_atwood():
    """Three masses hang over a wheel, over a point without friction, and on a block: constant accelerations."""
    rows = Rows()
    i, radius = 0.02, 0.2
    wheel = (2 - 1) * G / (2 + 1 + i / radius ** 2)
    point = (2 - 1.5) * G / 3.5
    big, small, of_block, of_guide = 3, 2, 0.01, 0.03
    block = (2 * small - big) * G / (big + of_block / 0.01 + 4 * small + 4 * of_guide / 0.01)
    for t in steps(0.8, 4):
        rows.put(t, 5, {"a.y": -1 - wheel * t * t / 2, "b.y": -3 + wheel * t * t / 2})
        rows.put(t, 20, {"a.dy": -wheel * t, "w.wz": wheel * t / radius})
        rows.put(t, 100, {"over.tension1": 2 * (G - wheel), "over.tension2": G + wheel, "over.tension": 2 * (G - wheel)})
        rows.put(t, 5, {"over.length": 4 + 0.2 * math.pi})
        rows.put(t, 5, {"c.y": -1 - point * t * t / 2, "d.y": -2 + point * t * t / 2, "through.length": 4})
        rows.put(t, 100, {"through.tension": 2 * (G - point)})
        rows.put(t, 5, {"e.y": -2 + block * t * t / 2, "f.y": -1 - block * t * t})
        last = small * (G - 2 * block)
        middle = last - of_guide * 2 * block / 0.01
        rows.put(t, 100, {"hoist.tension3": last, "hoist.tension2": middle, "hoist.tension1": big * (G + block) - middle})
    return rows


def rope_tilted():
    """A double machine of Atwood: with a of the lower wheel and s of the light weight beside it, both upwards, and wheels of
    which each counts as 0.1 kg at the rope,  g + a = 3.1 s,  g / 5 + 6.3 a = s."""
    rows = Rows()
    a = G * (1 / 3.1 - 0.2) / (6.3 - 1 / 3.1)
    s = (G + a) / 3.1
    for t in steps(0.7, 7):
        for heavy, wheel, light, middle in (("m1", "low", "m2", "m3"), ("n1", "deep", "n2", "n3")):
            rows.put(t, 5, {f"{heavy}.y": 1 - a * t * t / 2, f"{wheel}.y": 1.2 + a * t * t / 2})
            rows.put(t, 5, {f"{light}.y": 0.2 + (a + s) * t * t / 2, f"{middle}.y": 0.2 + (a - s) * t * t / 2})
        rows.put(t, 100, {"r2.tension1": G + a + s, "r2.tension2": 2 * (G + a - s), "v2.tension1": G + a + s})
    return rows


def rope_blow():
    """The same, and then a blow that keeps the energy: the ropes stay taut."""
    a = G * (1 / 3.1 - 0.2) / (6.3 - 1 / 3.1)
    s = (G + a) / 3.1
    rows = Rows()
    for t in (0.3, 0.6, 0.7, 0.74, 0.77, 0.8):
        rows.put(t, 20, {"scene.energy": G * (3 * 1 + 0.2 * 1.2 + 1 * 0.2 + 2 * 0.2)})
        if t < 0.73:
            rows.put(t, 5, {"m1.y": 1 - a * t * t / 2, "m2.y": 0.2 + (a + s) * t * t / 2})
    return rows


def rope_sways():
    """A bob at a drum of radius R about z, with the direction u and the length l of the span within the plane, left beside u, and
    the length L in space: the rope, L + R q with q the angle of u, stays as long as it is. So the tension pulls along its gradient
    n = l/L u + (R/l - R/L) left + z/L, and  n' v + n v' = 0."""
    rows, at, radius, mass = Rows(), steps(2, 10), 0.2, 2

    def parts(y):
        px, py, z, vx, vy, vz = y
        l, L = math.sqrt(px * px + py * py - radius ** 2), math.sqrt(px * px + py * py + z * z - radius ** 2)
        square = px * px + py * py
        u = ((l * px - radius * py) / square, (l * py + radius * px) / square)  # p = l u - R left
        left = (-u[1], u[0])
        dl, dL, dq = (px * vx + py * vy) / l, (px * vx + py * vy + z * vz) / L, (left[0] * vx + left[1] * vy) / l
        along, beside = l / L, radius / l - radius / L
        dalong = dl / L - l * dL / L ** 2
        dbeside = -radius * dl / l ** 2 + radius * dL / L ** 2
        n = [along * u[i] + beside * left[i] for i in (0, 1)] + [z / L]
        dn = [(dalong - beside * dq) * u[i] + (dbeside + along * dq) * left[i] for i in (0, 1)] + [vz / L - z * dL / L ** 2]
        pull = mass * (dn[0] * vx + dn[1] * vy + dn[2] * vz - G * n[1]) / sum(x * x for x in n)
        return n, pull, L

    def rate(_, y):
        n, pull, _ = parts(y)
        return [*y[3:], -pull * n[0] / mass, -G - pull * n[1] / mass, -pull * n[2] / mass]

    for t, y in zip(at, solve(rate, [-radius, -1, 0, 0.3, 0, 0.5], at)):
        _, pull, length = parts(y)
        rows.put(t, 10, {"b.x": y[0], "b.y": y[1], "b.z": y[2], "r.length": length})
        rows.put(t, 200, {"r.tension": pull})
    return rows


def rope_swinging():
    """Atwood's machine with one mass that swings:  (m + M) r'' = m r a'^2 + g (m cos a - M),  r a'' = -2 r' a' - g sin a."""
    rows, at = Rows(), steps(4, 12)
    m, big = 1, 3

    def rate(_, y):
        r, a, dr, da = y
        return [dr, da, (m * r * da * da + G * (m * math.cos(a) - big)) / (m + big), (-2 * dr * da - G * math.sin(a)) / r]

    for t, (r, a, dr, da) in zip(at, solve(rate, [1, 1.5707963267948966, 0, 0], at)):
        rows.put(t, 5, {"m.x": r * math.sin(a), "m.y": -r * math.cos(a), "big.y": -3 + (r - 1), "r.length": 5})
        rows.put(t, 200, {"r.tension": big * (G + rate(0, [r, a, dr, da])[2])})
    return rows


def rope_peg():
    """A pendulum that winds up on a peg: with the direction (sin a, -cos a) and l = l0 - R a,  l a'' = R a'^2 - g sin a."""
    rows, at, radius = Rows(), steps(3, 12), 0.1

    def rate(_, y):
        return [y[1], (radius * y[1] ** 2 - G * math.sin(y[0])) / (1 - radius * y[0])]

    for t, (a, w) in zip(at, solve(rate, [0, 2.5], at)):
        l = 1 - radius * a
        rows.put(t, 5, {"b.x": -radius * math.cos(a) + l * math.sin(a), "b.y": -radius * math.sin(a) - l * math.cos(a), "r.length": l})
        rows.put(t, 100, {"r.tension": G * math.cos(a) + l * w * w})
    return rows


def rope_galileo():
    """A string of 1 m from the origin that meets a peg of radius R at (R, -0.5): before,  a'' = -g sin a;  on the peg, as rope_peg,
    with l = 1 - 0.5 - R a. It touches where the string hangs down. The rest follows by the symmetry of the swing in time."""
    rows, radius = Rows(), 0.01

    def free(_, y):
        return [y[1], -G * math.sin(y[0])]

    def wound(_, y):
        return [y[1], (radius * y[1] ** 2 - G * math.sin(y[0])) / (0.5 - radius * y[0])]

    def first(rate, start, reached):  # the time at which reached(state) >= 0, by Newton's method on the rate of a
        t = 0.5
        for _ in range(40):
            y = solve(rate, start, [t])[0]
            t -= reached(y) / rate(0, y)[reached.of]
        return t

    def down(y):
        return y[0]
    down.of = 0

    def turned(y):
        return y[1]
    turned.of = 1
    begin = [-math.atan2(0.6, 0.8), 0.0]
    touch = first(free, begin, down)
    speed = solve(free, begin, [touch])[0][1]
    # The string that lies on the peg is vertical: its bob is 1 m below the pivot, and turns about the peg from there.
    turn = first(wound, [0.0, speed * 1 / 0.5], turned)
    for t in (0.2, 0.4, touch - 0.01, touch + 0.1, touch + turn, touch + 2 * turn - 0.1, touch + 2 * turn + 0.1, 2 * touch + 2 * turn,
              3 * touch + 2 * turn + 0.2, 3.4):
        s = t % (2 * touch + 2 * turn)
        s = s if s <= touch + turn else 2 * touch + 2 * turn - s
        if s <= touch:
            a = solve(free, begin, [s])[0][0]
            place = (math.sin(a), -math.cos(a))
        else:
            a = solve(wound, [0.0, speed / 0.5], [s - touch])[0][0]
            l = 0.5 - radius * a
            place = (radius - radius * math.cos(a) + l * math.sin(a), -0.5 - radius * math.sin(a) - l * math.cos(a))
        rows.put(t, 20, {"b.x": place[0], "b.y": place[1]})
        rows.put(t, 200, {"scene.energy": -0.8 * G})
    return rows


def rope_yoyo():
    """A yo-yo that swings: l' = R (a' - w),  (m R^2 + I) w' = -R m (l a'^2 + g cos a),  l a'' = R a'^2 - g sin a - 2 l' a'."""
    rows, at, radius, inertia = Rows(), steps(2, 10), 0.1, 0.04

    def rate(_, y):
        l, a, w, da = y
        dl = radius * (da - w)
        return [dl, da, -radius * (l * da * da + G * math.cos(a)) / (radius ** 2 + inertia),
                (radius * da * da - G * math.sin(a) - 2 * dl * da) / l]

    for t, (l, a, w, da) in zip(at, solve(rate, [1, 0, 0, 1.5], at)):
        rows.put(t, 8, {"y.x": l * math.sin(a) + radius * math.cos(a), "y.y": -l * math.cos(a) + radius * math.sin(a), "r.length": l})
        rows.put(t, 100, {"y.wz": w})
        rows.put(t, 100, {"r.tension": -inertia * rate(0, [l, a, w, da])[2] / radius})
    return rows


def rope_winch():
    """A drum turned by sin 3t winds a rope whose load swings:  l a'' = -g sin a - R a'^2 + 2 R w a',  l' = R (a' - w)."""
    rows, at, radius = Rows(), steps(3, 12), 0.2

    def rate(t, y):
        l, a, da = y
        w = math.sin(3 * t)
        return [radius * (da - w), da, (-G * math.sin(a) - radius * da * da + 2 * radius * w * da) / l]

    for t, (l, a, da) in zip(at, solve(rate, [2, 0, 0.7], at)):
        pull = 3 * (G * math.cos(a) + l * da * da + radius * 3 * math.cos(3 * t))
        rows.put(t, 5, {"m.x": radius * math.cos(a) + l * math.sin(a), "m.y": radius * math.sin(a) - l * math.cos(a), "r.length": l})
        rows.put(t, 200, {"r.tension": pull, "h.motor": radius * pull + 0.05 * 3 * math.cos(3 * t)})
    return rows


def rope_belt():
    """A belt between wheels of 0.1 and 0.2, of which one side pulls:  (I1 + I2 / 4) w' = cos t / 10."""
    rows, i1, i2 = Rows(), 0.02, 0.08
    for t in steps(6, 12):
        w = 0.1 * math.sin(t) / (i1 + i2 / 4)
        second = 0.1 * math.cos(t) / (i1 + i2 / 4)
        pull = i2 * second / 2 / 0.2
        rows.put(t, 10, {"a.wz": w, "b.wz": w / 2, "hb.q": 0.05 * (1 - math.cos(t)) / (i1 + i2 / 4)})
        rows.put(t, 10, {"r.tension2": max(pull, 0), "r.tension1": max(-pull, 0)})
    return rows


def rope_snaps():
    """A pendulum from the horizontal, whose rope breaks where 3 m g cos a passes 20."""
    rows = Rows()

    def rate(_, y):
        return [y[1], -G * math.sin(y[0])]

    def at(t):
        return solve(rate, [math.pi / 2, 0], [t])[0]

    end = first(0.1, 0.58, lambda t: 3 * G * math.cos(at(t)[0]) >= 20)
    a0, w0 = at(end)
    for t in [0.2, 0.3, 0.4, 0.6, 0.8, 1.0]:
        if t < end:
            a, w = at(t)
            rows.put(t, 5, {"b.x": math.sin(a), "b.y": -math.cos(a)})
            rows.put(t, 100, {"r.tension": 3 * G * math.cos(a)})
        else:
            s = t - end
            rows.put(t, 5, {"b.x": math.sin(a0) + w0 * math.cos(a0) * s, "b.y": -math.cos(a0) + w0 * math.sin(a0) * s - G * s * s / 2})
            rows.put(t, 100, {"r.tension": 0})
    return rows


# --- what a blow and a weak motor do --------------------------------------------------------------

def hit_stop():
    """A ball of 1 at speed 2 comes back from a block on its stop, stops at a free one, and drives two that hang together."""
    rows = Rows()
    for t in [0.5, 1.0, 1.5, 2.0]:
        s = max(t - 0.8, 0)  # since the blow
        rows.put(t, 10, {"ball.x": -0.4 - 2 * s if s > 0 else -2 + 2 * t, "block.x": 0})
        rows.put(t, 10, {"free.x": 2 * s, "ball1.x": -0.4 if s > 0 else -2 + 2 * t})
        rows.put(t, 10, {"first.x": s * 4 / 3, "second.x": s * 4 / 3 - 1, "pulled.length": math.sqrt(5)})
        rows.put(t, 10, {"ball2.x": -0.4 - s * 2 / 3 if s > 0 else -2 + 2 * t})
    return rows


def coupled_brakes():
    """Two sliders with brakes of 1 on a rod: 3 t moves both from t = 2 / 3 on."""
    rows = Rows()
    for t in [0.5, 0.7, 1.0, 1.5, 2.0]:
        s = max(t - 2 / 3, 0)
        rows.put(t, 2, {"a.x": s ** 3 / 4, "b.x": 1 + s ** 3 / 4})
        rows.put(t, 10, {"a.dx": 0.75 * s * s})
    return rows


def weak_servo():
    """A place of sin t is held with at most 0.5 on 1 kg: it slips where |sin t| > 0.5, and holds the speed of cos t again later."""
    rows, last = Rows(), 6.0
    t, q, v, force, parts = 0.0, 0.0, 1.0, None, []
    while t < last:
        parts.append((t, q, v, force))
        if force is None:
            end = t
            while end < last and abs(math.sin(end)) <= 0.5:
                end += 1e-3
            end = first(end - 1e-3, end, lambda u: abs(math.sin(u)) > 0.5)
            q, v, force = q + math.sin(end) - math.sin(t), math.cos(end), -math.copysign(0.5, math.sin(end))
        else:
            end, side = t + 1e-3, math.copysign(1, v + force * 1e-3 - math.cos(t + 1e-3))
            while end < last and (v + force * (end - t) - math.cos(end)) * side > 0:
                end += 1e-3
            end = first(end - 1e-3, end, lambda u: (v + force * (u - t) - math.cos(u)) * side <= 0)
            s = end - t
            q, v = q + v * s + force * s * s / 2, v + force * s
            force = None if abs(math.sin(end)) <= 0.5 else -math.copysign(0.5, math.sin(end))
        t = end
    for time in steps(last, 24):
        t, q, v, force = [part for part in parts if part[0] < time][-1]
        s = time - t
        if force is None:
            rows.put(time, 5, {"rail.q": q + math.sin(time) - math.sin(t), "rail.dq": math.cos(time), "rail.motor": -math.sin(time)})
        else:
            rows.put(time, 5, {"rail.q": q + v * s + force * s * s / 2, "rail.dq": v + force * s, "rail.motor": force})
    return rows


def speed_jump():
    """A hinge turns at 1 from the time at which a free body passes 0.7."""
    rows = Rows()
    for t in [0.3, 0.6, 0.75, 1.0, 1.5, 2.0]:
        rows.put(t, 3, {"pin.q": max(t - 0.7, 0)})
        rows.put(t, 10, {"pin.dq": 1 if t > 0.7 else 0})
    return rows


def rope_corner():
    """From the last hop on (before 1.75) the rope is as long as it is."""
    rows = Rows()
    for t in [1.8, 1.9, 2.0]:
        rows.put(t, 2, {"r.length": 1.2})
    return rows


CASES = (rope_drop, rope_slack, rope_atwood, rope_light_wheel, rope_tilted, rope_blow, rope_sways, rope_swinging, rope_peg, rope_galileo, rope_yoyo,
         rope_winch, rope_belt, rope_snaps, hit_stop, coupled_brakes, weak_servo, speed_jump, rope_corner)
