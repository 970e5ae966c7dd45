"""Letters as strokes of a pen, so that they are sharp at any scale.

A glyph is a list of strokes, a stroke a list of points on a grid: x from 0, y from 0 (baseline) over 4 (small letters)
to 6 (capitals); a and b are 1 and 2 below the baseline. Two characters are a point, a point twice is a dot.
"""
import unicodedata

HEIGHT = 6.0
_GAP = 1.7

_WRITTEN = {
    "A": "002640 1232", "B": "00063645443303 3342413000", "C": "4536160501103041", "D": "00062644422000",
    "E": "46060040 0333", "F": "460600 0333", "G": "45361605011030414323", "H": "0006 4046 0343",
    "I": "1016 0020 0626", "J": "3631201001", "K": "0006 4602 1340", "L": "060040", "M": "0006234640",
    "N": "00064046", "O": "163645413010010516", "P": "00063645443303", "Q": "163645413010010516 2240",
    "R": "00063645443303 2340", "S": "453616050413334241301001", "T": "0646 2620", "U": "060110304146",
    "V": "062046", "W": "0610243046", "X": "0046 0640", "Y": "062346 2320", "Z": "06460040",
    "a": "0314243330 321201102031", "b": "0600 0314243331201001", "c": "3324140301102031",
    "d": "3630 3324140301102031", "e": "02323324140301102031", "f": "261510 0424",
    "g": "343a2b1b0a 3324140301102031", "h": "0600 0314243330", "i": "0004 0606", "j": "141a0b 1616",
    "k": "0600 3401 1230", "l": "060110", "m": "0400 03142320 23344340", "n": "0400 0314243330",
    "o": "142433312010010314", "p": "040b 0314243331201001", "q": "343b 3324140301102031", "r": "0400 031424",
    "s": "33241403122231201001", "t": "161120 0424", "u": "0401102031 3430", "v": "041024", "w": "0410233044",
    "x": "0034 0430", "y": "0411 240b", "z": "04340030",
    "0": "162635312010010516", "1": "152620 1030", "2": "05162635340030", "3": "051626353423 13233231201001",
    "4": "20260232", "5": "360604243331201001", "6": "352616050110203133241403", "7": "063610",
    "8": "162635342313040516 1302011020313223", "9": "011020313526160503122233",
    ".": "0000", ",": "000a", ":": "0000 0303", ";": "0303 000a", "-": "0323", "+": "0343 2125", "/": "0036",
    "(": "16050110", ")": "06151100", "[": "16060010", "]": "06161000", "%": "0046 0505 4141", "=": "0434 0232",
    "!": "0602 0000", "?": "05162635342312 1010", "'": "0605", '"': "0605 2625", "_": "0040", "<": "350331",
    ">": "053301", "*": "0333 1521 2511", "#": "1016 3036 0444 0242", "°": "0516251405", "|": "0b06", "^": "041624",
    "&": "40051626351201102032",
}


def _points(stroke):
    below = {"a": -1, "b": -2}
    return [(int(stroke[i]), below.get(stroke[i + 1], None) if stroke[i + 1] in below else int(stroke[i + 1]))
            for i in range(0, len(stroke), 2)]


_GLYPHS = {letter: [_points(stroke) for stroke in text.split()] for letter, text in _WRITTEN.items()}
_UNKNOWN = [_points("0006363000")]


def _glyph(letter):
    if letter in _GLYPHS:
        return _GLYPHS[letter]
    plain = unicodedata.normalize("NFD", letter)[0]  # without its accent
    return _GLYPHS.get(plain, _UNKNOWN)


def _advance(letter):
    if letter == " ":
        return 3.2
    return max(x for stroke in _glyph(letter) for x, _ in stroke) + _GAP


def width(text, size):
    """Of the text in pixels, when capitals are `size` pixels high."""
    return (sum(_advance(letter) for letter in text) - (_GAP if text else 0)) * size / HEIGHT


def draw(canvas, x, y, text, size, color, weight=0.13):
    """With the baseline's left end at x, y."""
    unit = size / HEIGHT
    for letter in text:
        for stroke in () if letter == " " else _glyph(letter):
            points = [(x + px * unit, y - py * unit) for px, py in stroke]
            for a, b in zip(points, points[1:]):
                canvas.line(a, b, max(1.0, weight * size), color)
        x += _advance(letter) * unit
