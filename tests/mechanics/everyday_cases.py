"""The values of everyday machines: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from rope_cases import rope_galileo


def galileo():
    rows = Rows()
    for t, expression, value, scale in rope_galileo():
        if expression.startswith("b."):
            rows.put(t, scale, {"ball" + expression[1:]: value})
    return rows


def lift():
    rows = Rows()
    for t, way, gains in ((1.0, 0.5, 1), (2.5, 3.0, 0), (3.5, 5.0, 0), (5.0, 7.5, -1), (6.0, 8.0, -1)):
        rows.put(t, 9, {"shaft.q": way, "man.py(0,0,0)": 0.8 + way})
        rows.put(t, 1000, {"scales.n": 80 * (G + gains)})
    return rows


def pile_driver():
    rows, meets = Rows(), math.sqrt(4 / G)
    speed, slows = 2 / 3 * G * meets, 60000 / 900 - G
    for t in [0.3, 0.6, meets + 0.03, meets + 0.06, 1.0, 1.4]:
        s = min(max(t - meets, 0), speed / slows)
        rows.put(t, 4, {"soil.q": -(speed * s - slows * s * s / 2)})
        rows.put(t, 4, {"hammer.y": 3.8 - G * t * t / 2 if t < meets else 1.8 - (speed * s - slows * s * s / 2)})
    return rows


def cam():
    rows = Rows()
    for t in steps(4, 10):
        rows.put(t, 1, {"rail.q": 0.1 * math.sin(4 * t)})
        rows.put(t, 20, {"touch.n": G - 1.6 * math.sin(4 * t)})
    return rows


def turning_chair():
    rows = Rows()
    for t in [0.5, 1.0, 1.25, 1.5, 1.75, 2.0, 3.0]:
        r = 0.8 - 0.25 * (1 - math.cos(math.pi * min(max(t - 1, 0), 1)))
        rows.put(t, 10, {"axle.dq": 2 * (2.7 + 2 * (5 * 0.64 + 0.02)) / (2.7 + 2 * (5 * r * r + 0.02))})
    return rows


def table_pulley():
    rows, gains, slows = Rows(), 0.4 * G / 3, 0.3 * G
    lands = math.sqrt(1 / gains)
    for t in [0.3, 0.8, lands, 1.0, 1.5, 2.0]:
        s = min(t, lands)
        behind = min(t - s, gains * lands / slows)
        rows.put(t, 2, {"block.x": -0.7 + gains * s * s / 2 + gains * lands * behind - slows * behind * behind / 2})
        if t < lands:
            rows.put(t, 20, {"line.tension": G - gains})
    return rows
