"""The text of a chart: options as `name: value`, then rows with commas between their cells.

    title: Mean temperature
    kind: lines            (or bars, points)
    unit: °C
    Month, Oslo, Rome
    Jan, -4.3, 7.5
    Feb, -4.0, 8.2

The first row names the columns, the first cell of each other row stands below the axis. Reading never fails: what
cannot be read is left out and listed as (line, column, end column, sentence).
"""
import math

KINDS = ("lines", "bars", "points")
MOST_CELLS = 20000


class Table:
    def __init__(self):
        self.title = self.unit = self.axis = ""
        self.kind = "lines"
        self.names, self.rows, self.columns = [], [], []  # columns[i] belongs to names[i]; None: an empty cell
        self.faults = []

    def range(self):
        values = [v for column in self.columns for v in column if v is not None]
        if self.kind == "bars" or not values:
            values = values + [0.0]
        return min(values), max(values)

    def at(self, series, place):
        """The value at a place along the axis, in rows, between two neighbours."""
        column = self.columns[series]
        if not column:
            return None
        i = min(max(math.floor(place), 0), len(column) - 1)
        j = min(i + 1, len(column) - 1)
        if column[i] is None or column[j] is None:
            return column[i]
        return column[i] + (column[j] - column[i]) * min(max(place - i, 0.0), 1.0)


def read(text):
    table, cells = Table(), 0
    for number, line in enumerate(text.split("\n"), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        name, colon, value = line.partition(":")
        if colon and "," not in name and not table.names:
            _option(table, number, line, name.strip(), value.strip())
        elif not table.names:
            table.axis, *table.names = [cell.strip() for cell in line.split(",")]
            table.columns = [[] for _ in table.names]
            if not table.names:
                table.faults.append((number, 1, len(line) + 1, "a row of names wants at least two, with commas between"))
        else:
            cells += len(table.names)
            if cells > MOST_CELLS:
                table.faults.append((number, 1, len(line) + 1, f"more than {MOST_CELLS} cells: the rest is left out"))
                break
            _row(table, number, line)
    if not table.rows and not table.faults:
        table.faults.append((1, 1, 1, "no rows: a row is a label and numbers, with commas between"))
    return table


def _option(table, number, line, name, value):
    if name in ("title", "unit"):
        setattr(table, name, value)
    elif name == "kind" and value in KINDS:
        table.kind = value
    elif name == "kind":
        table.faults.append((number, line.find(":") + 2, len(line) + 1, f'no kind of chart "{value}" (kinds: {", ".join(KINDS)})'))
    else:
        table.faults.append((number, 1, len(line) + 1, f'no option "{name}" (options: title, unit, kind)'))


def _row(table, number, line):
    cells = line.split(",")
    if len(cells) > len(table.names) + 1:
        table.faults.append((number, 1, len(line) + 1, f"{len(cells)} cells, but {len(table.names) + 1} names"))
    table.rows.append(cells[0].strip())
    column = len(cells[0]) + 2
    for i, values in enumerate(table.columns):
        cell = cells[i + 1] if i + 1 < len(cells) else ""
        values.append(_number(table, number, column, cell))
        column += len(cell) + 1


def _number(table, line, column, cell):
    if not cell.strip():
        return None
    try:
        value = float(cell)
        if not math.isfinite(value) or abs(value) > 1e15:
            raise ValueError
        return value
    except ValueError:
        start = column + len(cell) - len(cell.lstrip())
        table.faults.append((line, start, start + len(cell.strip()), f'"{cell.strip()}" is not a number'))
        return None
