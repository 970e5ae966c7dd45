"""A table as a picture: axes with round numbers, a legend, the data, and what is under the pointer or the cursor."""
import math

import strokes
from raster import Canvas

INK, GREY, PALE = (40, 44, 52), (120, 126, 138), (226, 229, 234)
COLORS = [(31, 105, 181), (214, 93, 14), (38, 139, 76), (161, 60, 150), (176, 137, 0), (90, 98, 110)]


def ticks(low, high, wanted):
    """Round numbers from below `low` to above `high`: 1, 2 or 5 times a power of ten apart."""
    if high <= low:
        low, high = low - 0.5, high + 0.5
    raw = (high - low) / max(wanted, 1)
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 5, 10) if m * power >= raw * 0.999)
    first, last = math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9)
    return [i * step for i in range(first, last + 1)]


def number(value):
    return f"{value:.6g}" if value else "0"


class Chart:
    """The part that does not change while time runs is drawn once."""

    def __init__(self, table, kinds, width, height, scale):
        self.table, self.kinds, self.scale = table, kinds, scale
        self.canvas = Canvas(width, height)
        self.letter = 7.5 * scale
        self._lay_out()
        self._draw_frame()
        self._draw_data()

    def _lay_out(self):
        s, table = self.scale, self.table
        low, high = table.range()
        self.ticks = ticks(low, high, max(2, (self.canvas.height - 60 * s) / (34 * s)))
        labels = max(strokes.width(number(t), self.letter) for t in self.ticks)
        self.left, self.right = labels + 16 * s, self.canvas.width - 14 * s
        self.top = (30 if table.title else 14) * s + (16 * s if len(table.names) > 1 or table.unit else 0)
        self.bottom = self.canvas.height - 26 * s

    def x(self, place):
        count = len(self.table.rows)
        if "bars" in self.kinds or count < 2:
            return self.left + (self.right - self.left) * (place + 0.5) / max(count, 1)
        return self.left + (self.right - self.left) * place / (count - 1)

    def y(self, value):
        low, high = self.ticks[0], self.ticks[-1]
        return self.bottom - (self.bottom - self.top) * (value - low) / (high - low)

    def place(self, x):
        """The nearest row to a pixel; None beside the chart."""
        rows = range(len(self.table.rows))
        if not rows or not self.left - 8 <= x <= self.right + 8:
            return None
        return min(rows, key=lambda i: abs(self.x(i) - x))

    def _draw_frame(self):
        c, s, table = self.canvas, self.scale, self.table
        if table.title:
            size = 9.5 * s
            strokes.draw(c, (c.width - strokes.width(table.title, size)) / 2, 22 * s, table.title, size, INK, 0.15)
        for tick in self.ticks:
            y = round(self.y(tick))
            c.rectangle(self.left, y, self.right, y + max(1, round(s)), GREY if tick == 0 else PALE)
            text = number(tick)
            strokes.draw(c, self.left - 7 * s - strokes.width(text, self.letter), y + self.letter / 2, text, self.letter, GREY)
        widest = max((strokes.width(row, self.letter) for row in table.rows), default=0) + 8 * s
        room = (self.right - self.left) / max(len(table.rows), 1)
        every = max(1, math.ceil(widest / room))
        for i in range(0, len(table.rows), every):
            text = table.rows[i]
            x = self.x(i) - strokes.width(text, self.letter) / 2
            x = min(max(x, 2), c.width - 2 - strokes.width(text, self.letter))
            strokes.draw(c, x, self.bottom + 16 * s, text, self.letter, GREY)
        self._draw_legend()

    def _draw_legend(self):
        c, s, x = self.canvas, self.scale, self.left
        y = self.top - 10 * s
        for i, name in enumerate(self.table.names if len(self.table.names) > 1 else []):
            c.line((x, y - self.letter / 2), (x + 12 * s, y - self.letter / 2), 3 * s, COLORS[i % len(COLORS)])
            strokes.draw(c, x + 18 * s, y, name, self.letter, INK)
            x += 32 * s + strokes.width(name, self.letter)
        if self.table.unit:
            strokes.draw(c, self.right - strokes.width(self.table.unit, self.letter), y, self.table.unit, self.letter, GREY)

    def _draw_data(self):
        for i, values in enumerate(self.table.columns):
            color = COLORS[i % len(COLORS)]
            if "bars" in self.kinds:
                self._draw_bars(i, values, color)
            known = [(self.x(k), self.y(v)) for k, v in enumerate(values) if v is not None]
            if "lines" in self.kinds:
                gaps = [None if v is None else (self.x(k), self.y(v)) for k, v in enumerate(values)]
                for a, b in zip(gaps, gaps[1:]):
                    if a and b:
                        self.canvas.line(a, b, 2 * self.scale, color)
            if "points" in self.kinds:
                for x, y in known:
                    self.canvas.disc(x, y, 3.2 * self.scale, color)

    def _draw_bars(self, series, values, color):
        room = (self.right - self.left) / max(len(values), 1) * 0.8
        width, zero = room / len(self.table.columns), self.y(0)
        for i, value in enumerate(values):
            if value is not None:
                left = self.x(i) - room / 2 + series * width
                self.canvas.rectangle(left + 0.5, min(self.y(value), zero), left + width - 0.5, max(self.y(value), zero), color)

    def picture(self, cursor=None, hovered=None):
        """With a cursor at a place along the axis, and the values of the row under the pointer."""
        if cursor is None and hovered is None:
            return self.canvas
        canvas, s = self.canvas.copy(), self.scale
        place = hovered if hovered is not None else cursor
        x = self.x(place)
        canvas.rectangle(x - s / 2, self.top, x + s / 2, self.bottom, GREY)
        lines = []
        for i, name in enumerate(self.table.names):
            value = self.table.at(i, place)
            if value is not None:
                canvas.disc(x, self.y(value), 4 * s, (255, 255, 255))
                canvas.disc(x, self.y(value), 3 * s, COLORS[i % len(COLORS)])
                lines.append((f"{name} {value:.4g}", COLORS[i % len(COLORS)]))
        if hovered is not None:
            lines.insert(0, (self.table.rows[hovered], INK))
        if lines:
            self._draw_note(canvas, x, lines)
        return canvas

    def _draw_note(self, canvas, x, lines):
        s, pitch = self.scale, self.letter * 1.8
        width = max(strokes.width(text, self.letter) for text, _ in lines) + 12 * s
        left = x + 8 * s if x + 8 * s + width < canvas.width else x - 8 * s - width
        bottom = self.top + pitch * len(lines) + 8 * s
        canvas.rectangle(left, self.top, left + width, bottom, PALE)
        canvas.rectangle(left + s, self.top + s, left + width - s, bottom - s, (255, 255, 255))
        for i, (text, color) in enumerate(lines):
            strokes.draw(canvas, left + 6 * s, self.top + pitch * (i + 1) - 2 * s, text, self.letter, color)
