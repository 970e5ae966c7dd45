"""Ordinary differential equations to rounding, in plain Python: an own solver beside the engine's.

Gragg's method: the modified midpoint rule with 2, 4, ..., 18 parts, whose error is a series in the square of the part,
extrapolated to parts of length 0 (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.9). The difference
of the last two extrapolations decides the step.
"""
COLUMNS = 9
LEAST_STEP = 1e-3  # below it the difference is rounding


def midpoint(rate, t, y, step, parts):
    h = step / parts
    before, now = y, [a + h * b for a, b in zip(y, rate(t, y))]
    for i in range(1, parts):
        before, now = now, [a + 2 * h * b for a, b in zip(before, rate(t + i * h, now))]
    return [(a + b + h * c) / 2 for a, b, c in zip(before, now, rate(t + step, now))]


def extrapolated(rate, t, y, step):
    """The state a step later, and how far the last two extrapolations differ."""
    rows, error = [], 1.0
    for k in range(COLUMNS):
        row = [midpoint(rate, t, y, step, 2 * k + 2)]
        for j in range(1, k + 1):
            factor = ((k + 1) / (k + 1 - j)) ** 2 - 1
            row.append([a + (a - b) / factor for a, b in zip(row[j - 1], rows[k - 1][j - 1])])
        if k > 0:
            error = max(abs(a - b) / (1 + abs(a)) for a, b in zip(row[-1], row[-2]))
        rows.append(row)
    return rows[-1][-1], error


def solve(rate, y, times, tolerance=1e-13, land=None, start=0.0):
    """States at the times (ascending). land(t, y) moves each accepted state onto what it must satisfy."""
    t, y, step, found = start, list(y), 0.05, []
    for finish in times:
        while t < finish:
            last = t + step >= finish
            taken = finish - t if last else step
            after, error = extrapolated(rate, t, y, taken)
            factor = 0.8 * (tolerance / max(error, 1e-30)) ** (1 / (2 * COLUMNS - 1))
            if error > tolerance and taken > LEAST_STEP:
                step = taken * max(0.2, min(factor, 0.7))
                continue
            t, y = finish if last else t + taken, land(t + taken, after) if land else after
            if not last or factor < 1:
                step = max(LEAST_STEP, taken * min(2.0, max(0.5, factor)))
        found.append(list(y))
    return found
