"""Shapes into pixels B, G, R, X, with smooth edges: each pixel takes as much colour as it is covered."""
import math


class Canvas:
    def __init__(self, width, height, background=(255, 255, 255)):
        self.width, self.height = width, height
        r, g, b = background
        self.pixels = bytearray(bytes((b, g, r, 255)) * (width * height))

    def copy(self):
        other = Canvas.__new__(Canvas)
        other.width, other.height, other.pixels = self.width, self.height, bytearray(self.pixels)
        return other

    def _blend(self, x, y, color, cover):
        if cover <= 0 or not (0 <= x < self.width and 0 <= y < self.height):
            return
        at = 4 * (y * self.width + x)
        pixels, keep = self.pixels, 1 - min(cover, 1.0)
        r, g, b = color
        pixels[at] = int(pixels[at] * keep + b * (1 - keep) + 0.5)
        pixels[at + 1] = int(pixels[at + 1] * keep + g * (1 - keep) + 0.5)
        pixels[at + 2] = int(pixels[at + 2] * keep + r * (1 - keep) + 0.5)

    def rectangle(self, left, top, right, bottom, color, opacity=1.0):
        left, right = max(left, 0.0), min(right, float(self.width))
        top, bottom = max(top, 0.0), min(bottom, float(self.height))
        if right <= left or bottom <= top:
            return
        r, g, b = color
        first, last = math.ceil(left), math.floor(right)  # whole columns
        for y in range(math.floor(top), math.ceil(bottom)):
            cover = (min(y + 1, bottom) - max(y, top)) * opacity
            if cover >= 1 and last > first:
                at = 4 * (y * self.width + first)
                self.pixels[at:at + 4 * (last - first)] = bytes((b, g, r, 255)) * (last - first)
            else:
                for x in range(first, last):
                    self._blend(x, y, color, cover)
            if last < first:  # within one column
                self._blend(last, y, color, cover * (right - left))
            else:
                self._blend(first - 1, y, color, cover * (first - left))
                self._blend(last, y, color, cover * (right - last))

    def disc(self, x, y, radius, color):
        self.line((x, y), (x, y), 2 * radius, color)

    def line(self, a, b, width, color):
        """With round ends. The cover of a pixel is taken from its centre's distance."""
        (ax, ay), (bx, by) = a, b
        dx, dy, reach = bx - ax, by - ay, width / 2 + 0.5
        length = math.hypot(dx, dy)
        along = (dx / length, dy / length) if length > 0 else (1.0, 0.0)
        for y in range(max(0, math.floor(min(ay, by) - reach)), min(self.height, math.ceil(max(ay, by) + reach))):
            cy = y + 0.5
            low, high = min(ax, bx) - reach, max(ax, bx) + reach
            if abs(along[1]) > 0.01:  # the strip crosses this row only here
                middle, half = ax + (cy - ay) * along[0] / along[1], reach / abs(along[1])
                low, high = max(low, middle - half), min(high, middle + half)
            for x in range(max(0, math.floor(low)), min(self.width, math.ceil(high))):
                px, py = x + 0.5 - ax, cy - ay
                t = min(max(px * along[0] + py * along[1], 0.0), length)
                distance = math.hypot(px - t * along[0], py - t * along[1])
                self._blend(x, y, color, reach - distance)
