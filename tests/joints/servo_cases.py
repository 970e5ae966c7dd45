"""Arms whose motors are too weak, on a turntable or without one. Letters as in the scenes; SI units.

Two rods, each of length L, mass m and centre at h = L/2, stand up at the angles a, b from the vertical in a plane that a
turntable turns with speed W. With the moments of inertia I across a rod and K along it, and with J(a, b) of both rods
about the turntable's axis:

    (m h^2 + m L^2 + I) a'' + m L h cos(a - b) b'' = -m L h sin(a - b) b'^2 + m g (h + L) sin a + W^2/2 dJ/da + T1 - T2
    (m h^2 + I) b'' + m L h cos(a - b) a''         =  m L h sin(a - b) a'^2 + m g h sin b       + W^2/2 dJ/db + T2

A motor holds the rate of its place within its couple; else it gives the couple against the rate at which it slips.
"""
import itertools
import math

from cases import G, Rows, steps
from integration import solve
from rope_cases import first

LENGTH, WIDTH, MASS = 0.4, 0.08, 2.0
HALF, ACROSS, ALONG = LENGTH / 2, MASS * (LENGTH ** 2 + WIDTH ** 2) / 12, MASS * WIDTH ** 2 / 6
HOLDS, LOW, HIGH = 0, -1, 1
AHEAD = 1e-9


class Arm:
    """wanted[i](t): rate and second rate of motor i's place; most[i]: its greatest couple; turn(t): the turntable's angle and speed."""

    def __init__(self, wanted, most, turn):
        self.wanted, self.most, self.turn = wanted, most, turn

    def system(self, t, y):
        """M and f of  M (a'', b'') = f + (T1 - T2, T2)."""
        a, b, da, db = y
        speed = self.turn(t)[1]
        c, s = math.cos(a - b), math.sin(a - b)
        both = MASS * LENGTH * HALF
        reach = LENGTH * math.sin(a) + HALF * math.sin(b)
        by_a = 2 * MASS * (HALF ** 2 * math.sin(a) + reach * LENGTH) * math.cos(a) + (ACROSS - ALONG) * math.sin(2 * a)
        by_b = 2 * MASS * reach * HALF * math.cos(b) + (ACROSS - ALONG) * math.sin(2 * b)
        matrix = ((MASS * (HALF ** 2 + LENGTH ** 2) + ACROSS, both * c), (both * c, MASS * HALF ** 2 + ACROSS))
        force = (-both * s * db * db + MASS * G * (HALF + LENGTH) * math.sin(a) + speed ** 2 / 2 * by_a,
                 both * s * da * da + MASS * G * HALF * math.sin(b) + speed ** 2 / 2 * by_b)
        return matrix, force

    def answer(self, t, y, states):
        """Couples and accelerations (a'', b'') in those states."""
        ((m11, m12), (_, m22)), (f1, f2) = self.system(t, y)
        want = [rates(t)[1] for rates in self.wanted]
        # Unknown: a'', b'', T1, T2.
        known = [state * most for state, most in zip(states, self.most)]
        if states[0] == HOLDS and states[1] == HOLDS:
            second = (want[0], want[0] + want[1])
            t2 = m12 * second[0] + m22 * second[1] - f2
            return (m11 * second[0] + m12 * second[1] - f1 + t2, t2), second
        if states[0] == HOLDS:
            t2, first_rate = known[1], want[0]
            second_rate = (f2 + t2 - m12 * first_rate) / m22
            return (m11 * first_rate + m12 * second_rate - f1 + t2, t2), (first_rate, second_rate)
        if states[1] == HOLDS:  # both rows added: T2 is gone
            first_rate = (f1 + f2 + known[0] - (m12 + m22) * want[1]) / (m11 + 2 * m12 + m22)
            second_rate = first_rate + want[1]
            return (known[0], m12 * first_rate + m22 * second_rate - f2), (first_rate, second_rate)
        r1, r2, det = f1 + known[0] - known[1], f2 + known[1], m11 * m22 - m12 * m12
        return tuple(known), ((r1 * m22 - r2 * m12) / det, (m11 * r2 - m12 * r1) / det)

    def slips(self, t, y):
        """By how much each motor's rate is more than it should be."""
        return (y[2] - self.wanted[0](t)[0], y[3] - y[2] - self.wanted[1](t)[0])

    def second_slips(self, t, seconds):
        return (seconds[0] - self.wanted[0](t)[1], seconds[1] - seconds[0] - self.wanted[1](t)[1])

    def states_after(self, t, y, fixed):
        """The states that the laws give; `fixed[i]`: a motor that slips goes on, else None."""
        for states in itertools.product((HOLDS, LOW, HIGH), repeat=2):
            if any(now is not None and now != state for now, state in zip(fixed, states)):
                continue
            couples, seconds = self.answer(t, y, states)
            slips = self.second_slips(t, seconds)
            if all(now is not None or (abs(couple) <= most if state == HOLDS else slip * state <= 0)
                   for now, state, couple, most, slip in zip(fixed, states, couples, self.most, slips)):
                return states
        raise AssertionError("no states")

    def moved(self, t, y, states, to):
        if to <= t:
            return list(y)

        def land(at, values):  # what holds has the rate that is wanted
            a, b, da, db = values
            da = self.wanted[0](at)[0] if states[0] == HOLDS else da
            db = da + self.wanted[1](at)[0] if states[1] == HOLDS else db
            return [a, b, da, db]

        return solve(lambda s, v: [v[2], v[3], *self.answer(s, v, states)[1]], y, [to], land=land, start=t)[0]

    def ends(self, t, y, states):
        """For each motor whether its state is over; a slip that has just begun is none but for rounding."""
        couples, slips = self.answer(t, y, states)[0], self.slips(t, y)
        return [abs(couple) > most if state == HOLDS else slip * state > 1e-13
                for state, couple, most, slip in zip(states, couples, self.most, slips)]

    def motion(self, y, times, step=5e-3):
        """At each time: states, couples, values; and all times at which a state ends."""
        t, found, changes = 0.0, [], []
        states = self.states_after(AHEAD, y, (None, None))
        for finish in times:
            while t < finish:
                to = min(finish, t + step)
                after = self.moved(t, y, states, to)
                if not any(self.ends(to, after, states)):
                    t, y = to, after
                    continue
                end = first(t, to, lambda u: any(self.ends(u, self.moved(t, y, states, u), states)))
                y, t = self.moved(t, y, states, end), end
                over = self.ends(t, y, states)
                changes.append(t)
                for i, is_over in enumerate(over):  # a slip that ends is none
                    if is_over and states[i] != HOLDS:
                        y[2 + i] = (y[2] if i else 0) + self.wanted[i](t)[0]
                ahead = self.moved(t, y, states, t + AHEAD)  # at the bound itself the laws have both answers
                states = self.states_after(t + AHEAD, ahead, [None if o or s == HOLDS else s for o, s in zip(over, states)])
            found.append((states, self.answer(t, y, states)[0], list(y)))
        return found, changes


def wanted(t):
    """Of a place 0.5 (1 - cos 2t)."""
    return math.sin(2 * t), 2 * math.cos(2 * t)


def rows_of(arm):
    rows, at = Rows(), steps(3, 12)
    for t, (_, couples, (a, b, da, db)) in zip(at, arm.motion([0.0] * 4, at)[0]):
        rows.put(t, 5, {"j1.q": a, "j2.q": b - a})
        rows.put(t, 20, {"j1.dq": da, "j2.dq": db - da})
        rows.put(t, 100, {"j1.motor": couples[0], "j2.motor": couples[1]})
    return rows


def weak_arm():
    return rows_of(Arm([wanted] * 2, [10, 10], lambda t: (0, 0)))


def weak_arm_turning():
    return rows_of(Arm([wanted] * 2, [10, 3], lambda t: (0.5 * (1 - math.cos(t)), 0.5 * math.sin(t))))


def cam(wide=0.15):
    """Two rods of length 1, at q and q + p from the x axis; the first one's motor keeps q = 0.04 exp(-((p + 1)/wide)^2)."""
    rows, at, h, across = Rows(), steps(1, 10), 0.5, 1.01 / 12

    def place(p):
        """q, and its derivatives by p."""
        x = (p + 1) / wide
        q = 0.04 * math.exp(-x * x)
        return q, -2 * x / wide * q, (4 * x * x - 2) / wide ** 2 * q

    def second(p, w):
        """The second rates of p and q."""
        q, slope, bend = place(p)
        c, s, own = h * math.cos(p), h * math.sin(p), h * h + across
        known = (c + own) * bend * w * w + s * (slope * w) ** 2 + G * h * math.cos(q + p)
        rate = -known / ((c + own) * slope + own)
        return rate, slope * rate + bend * w * w

    for t, (p, w) in zip(at, solve(lambda t, y: [y[1], second(*y)[0]], [0.0, 0.0], at)):
        (q, slope, _), (of_p, of_q) = place(p), second(p, w)
        turn = slope * w + w
        rows.put(t, 3, {"j1.q": q, "j2.q": p, "b.x": math.cos(q) + h * math.cos(q + p), "b.y": math.sin(q) + h * math.sin(q + p)})
        rows.put(t, 60, {"j2.dq": w, "b.wz": turn})
        couple = ((h * h + 1 + across) * of_q + h * (math.cos(p) * (of_q + of_p) - math.sin(p) * turn ** 2)
                  + G * (h + 1) * math.cos(q))
        rows.put(t, 1000, {"j1.motor": couple})
    return rows


CASES = (weak_arm, weak_arm_turning, cam)
