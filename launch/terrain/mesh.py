"""The fluid mesh of a section: an orthogonal grid whose lowest cells are cut by the terrain.

Vertical lines of nodes stand at every vertex of the profile and in between; levels lie at one
spacing everywhere, one of them exactly at the lake level. So all faces are horizontal or vertical
but those on the terrain, and a lake at rest stays at rest. The lowest cell of a column reaches from
the terrain to the first level that gives it at least LOWEST of the nominal height. Where that level
changes from one column to the next, the lowest cell has several neighbours on that side: cells are
polyhedra, which OpenFOAM takes as they come.

At a shore the lowest cell on the water's side ends exactly at the lake level as a wedge, so that
no cell is half full in the beginning.

With levels at SPACING of the nominal height h, mean heights of all cells are within LOWEST and
LOWEST + SPACING = 1.5 h.
"""

from dataclasses import dataclass

import numpy as np

from .profile import Section

LOWEST = 0.6  # least mean height of a cell, in nominal heights
SPACING = 0.9  # distance of two levels, in nominal heights
WIDEST = 1.1  # greatest width of a column, in nominal heights
WEDGE = 1.3  # drop of the terrain under the wedge at a shore, in nominal heights


@dataclass(frozen=True)
class Columns:
    """Node lines and levels of a section; column c lies between lines c and c + 1.

    x, base: lines [m]; low, high: level at the top of each column's lowest cell and of its last
    cell, as indices into z [m] (the levels).
    """

    x: np.ndarray
    base: np.ndarray
    z: np.ndarray
    low: np.ndarray
    high: np.ndarray
    lake: int  # index of the lake level in z

    @property
    def cells(self):
        return int(np.sum(self.high - self.low + 1))

    def lowest_heights(self):
        """Mean height of each column's lowest cell [m]."""
        return self.z[self.low] - 0.5 * (self.base[1:] + self.base[:-1])


def make_columns(section: Section, cell_size: float):
    """Places node lines and levels for a nominal cell height [m]."""
    x, wedge = _lines(section, cell_size)
    base = section.height(x)
    spacing = SPACING * cell_size
    middle = 0.5 * (base[1:] + base[:-1])
    ceiling = np.maximum.reduce([
        np.full(len(x) - 1, section.lake_level + 350.0), middle + 150.0,
        np.maximum(section.ground_height(x[1:]), section.ground_height(x[:-1])) + 50.0])
    lake = int(np.ceil((section.lake_level - base.min()) / spacing)) + 1
    count = lake + int(np.ceil((ceiling.max() - section.lake_level) / spacing)) + 2
    z = section.lake_level + spacing * (np.arange(count) - lake)
    # The tolerance keeps round-off from lifting a cell that fits exactly.
    low = np.searchsorted(z, middle + LOWEST * cell_size - 1e-9)
    low[wedge] = lake
    high = np.searchsorted(z, ceiling)
    return Columns(x, base, z, low, high, lake)


def _lines(section, cell_size):
    """x of all node lines, and a mask of the columns that are wedges at a shore."""
    wall = section.wall
    stops = set(wall[:, 0])
    wedges = []
    for shore in section.shores():
        near = wall[np.argmin(np.abs(wall[:, 0] - shore)), 0]
        if abs(near - shore) < 0.3 * cell_size:
            shore = near  # a line a few centimetres from a vertex would only cost time steps
        end = _wedge_end(section, shore, cell_size)
        if end is not None:
            stops.update((shore, end))
            wedges.append((min(shore, end), max(shore, end)))
    stops = np.array(sorted(stops))
    lines = [stops[:1]]
    wedge = []
    for left, right in zip(stops[:-1], stops[1:]):
        is_wedge = (left, right) in wedges
        drop = abs(section.height(right) - section.height(left))
        parts = max((right - left) / (WIDEST * cell_size), drop / (SPACING * cell_size))
        parts = 1 if is_wedge else max(1, int(np.ceil(parts - 1e-9)))
        lines.append(np.linspace(left, right, parts + 1)[1:])
        wedge += [is_wedge] * parts
    return np.concatenate(lines), np.array(wedge)


def _wedge_end(section, shore, cell_size):
    """x on the water's side of a shore where the terrain has fallen by WEDGE cells, or None where
    a vertex of the profile comes first (then an ordinary column, half full, must do)."""
    x, z = section.wall[:, 0], section.wall[:, 1]
    toward = 1 if section.height(shore + 1e-6) < section.height(shore - 1e-6) else -1
    beyond = x[x > shore + 1e-9] if toward > 0 else x[x < shore - 1e-9][::-1]
    if not len(beyond):
        return None
    fall = section.height(shore) - section.height(beyond[0])
    end = shore + (beyond[0] - shore) * WEDGE * cell_size / fall if fall > 0 else np.inf
    # A remainder narrower than a third of a cell before the next vertex would be a sliver.
    fits = abs(end - shore) <= abs(beyond[0] - shore) - 0.3 * cell_size
    return float(end) if fits else None


@dataclass(frozen=True)
class Mesh:
    """OpenFOAM's polyMesh: points [m], faces as lists of points, owner, neighbour, patches as
    (name, type, faces), and for each cell its column and its polygon in the section."""

    points: np.ndarray
    faces: list
    owner: np.ndarray
    neighbour: np.ndarray
    patches: list
    column: np.ndarray
    outline: list  # arrays (n, 2) of x, z, counter-clockwise


def make_mesh(columns: Columns, width: float):
    """Turns columns into a mesh one cell of `width` [m] thick, from y = 0 to y = width."""
    plane, node = _nodes(columns)
    count = len(plane)
    points = np.empty((2 * count, 3))
    points[:, [0, 2]] = np.vstack([plane, plane])
    points[:count, 1], points[count:, 1] = 0.0, width
    first = np.concatenate([[0], np.cumsum(columns.high - columns.low + 1)])
    inner, outer, outline = [], {"terrain": [], "atmosphere": [], "uphill": [], "far": []}, []
    column = np.repeat(np.arange(len(columns.low)), np.diff(first))

    def quad(a, b):
        """Face through the edge a -> b of the section; its normal points right of a -> b."""
        return [a, a + count, b + count, b]

    def cell_at(c, top):
        """The cell of column c below level `top` and above the level under it."""
        return first[c] + max(0, top - columns.low[c])

    last = len(columns.low) - 1
    for c in range(last + 1):
        low, high = columns.low[c], columns.high[c]
        left, right = node[c], node[c + 1]
        outer["terrain"].append((first[c], quad(left[-1], right[-1])))
        for k in range(low, high):
            inner.append((cell_at(c, k), cell_at(c, k + 1), quad(right[k], left[k])))
        outer["atmosphere"].append((cell_at(c, high), quad(right[high], left[high])))
        for k in range(low, high + 1):
            outline.append(_outline(node[c], node[c + 1], k, low))
        if c == 0:
            _side(outer["uphill"], left, low, high, lambda k: cell_at(0, k),
                  lambda a, b: quad(b, a))
        if c == last:
            _side(outer["far"], right, low, high, lambda k, c=c: cell_at(c, k), quad)
            continue
        shared = min(high, columns.high[c + 1])
        edges = []
        _side(edges, right, min(low, columns.low[c + 1]), shared, lambda k: k, quad)
        inner += [(cell_at(c, k), cell_at(c + 1, k), face) for k, face in edges]
        for k in range(shared + 1, high + 1):
            outer["atmosphere"].append((cell_at(c, k), quad(right[k - 1], right[k])))
        for k in range(shared + 1, columns.high[c + 1] + 1):
            outer["atmosphere"].append((cell_at(c + 1, k), quad(right[k], right[k - 1])))
    # The section is seen with x to the right and z up: its normal is -y.
    outer["front"] = [(cell, list(polygon)) for cell, polygon in enumerate(outline)]
    outer["back"] = [(cell, [p + count for p in polygon[::-1]])
                     for cell, polygon in enumerate(outline)]
    return _assemble(points, inner, outer, column, [plane[polygon] for polygon in outline])


def _nodes(columns):
    """Points of the section, and per line a dict from level to point (-1: on the terrain)."""
    plane, node = [], []
    last = len(columns.low) - 1
    for i, (x, base) in enumerate(zip(columns.x, columns.base)):
        beside = [c for c in (i - 1, i) if 0 <= c <= last]
        low = min(columns.low[c] for c in beside)
        high = max(columns.high[c] for c in beside)
        line = {-1: len(plane)}
        plane.append((x, base))
        for k in range(low, high + 1):
            if abs(columns.z[k] - base) < 1e-9:  # the tip of a wedge is the shore itself
                line[k] = line[-1]
                continue
            line[k] = len(plane)
            plane.append((x, columns.z[k]))
        node.append(line)
    return np.array(plane), node


def _side(edges, line, low, high, cell_at, quad):
    """Appends (cell, face) for each edge of one node line from the terrain up to level `high`."""
    if line[low] != line[-1]:
        edges.append((cell_at(low), quad(line[-1], line[low])))
    for k in range(low + 1, high + 1):
        edges.append((cell_at(k), quad(line[k - 1], line[k])))


def _outline(left, right, k, low):
    """Points around the cell below level k, counter-clockwise in (x, z)."""
    if k > low:
        return [left[k - 1], right[k - 1], right[k], left[k]]
    up = [right[j] for j in sorted(j for j in right if -1 < j <= k)]
    down = [left[j] for j in sorted((j for j in left if -1 < j <= k), reverse=True)]
    around = [left[-1], right[-1], *up, *down]
    return list(dict.fromkeys(around))


def _assemble(points, inner, outer, column, outline):
    """Orders faces as OpenFOAM wants them: internal ones by owner, then neighbour."""
    turned = [(a, b, face) if a < b else (b, a, face[::-1]) for a, b, face in inner]
    turned.sort(key=lambda entry: entry[:2])
    faces = [face for _, _, face in turned]
    owner = [a for a, _, _ in turned]
    patches = []
    kinds = {"terrain": "wall", "front": "empty", "back": "empty"}
    for name, entries in outer.items():
        patches.append((name, kinds.get(name, "patch"), len(entries)))
        faces += [face for _, face in entries]
        owner += [cell for cell, _ in entries]
    return Mesh(points, faces, np.array(owner), np.array([b for _, b, _ in turned]), patches,
                column, outline)


def polygon_area(polygon):
    """Area [m2] of a counter-clockwise polygon of shape (n, 2)."""
    x, z = polygon[:, 0], polygon[:, 1]
    return 0.5 * float(np.sum(x * np.roll(z, -1) - np.roll(x, -1) * z))


def fraction_below(polygon, level):
    """Share of a convex polygon's area that lies below a level [m]."""
    if polygon[:, 1].max() <= level + 1e-9:
        return 1.0
    if polygon[:, 1].min() >= level - 1e-9:
        return 0.0
    cut = []
    for a, b in zip(polygon, np.roll(polygon, -1, axis=0)):
        if a[1] <= level:
            cut.append(a)
        if (a[1] - level) * (b[1] - level) < 0:
            cut.append(a + (b - a) * (level - a[1]) / (b[1] - a[1]))
    return polygon_area(np.array(cut)) / polygon_area(polygon) if len(cut) > 2 else 0.0
