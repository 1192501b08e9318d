"""A section's rock surface as LAMMPS regions: half-spaces, intersected in valleys and joined at ridges.

LAMMPS of Debian has no wall of triangles, but `fix wall/gran/region` takes any intersection and union of
half-spaces. A polyline splits at a vertex into the chains on its left and right, each continued by a straight
line; the side above it is the intersection of theirs where neither continuation rises above the other chain (a
valley), their union where neither falls below it (a ridge). Each segment so becomes one half-space, and no
contact counts twice (the formula of a simple chain: Dobkin, Guibas, Hershberger and Snoeyink 1988)."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Segment:
    """The half-space above the line from a to b, points (x, z) [m]."""

    a: np.ndarray
    b: np.ndarray

    def height(self, x):
        """Height of the line [m]."""
        return self.a[1] + (self.b[1] - self.a[1]) / (self.b[0] - self.a[0]) * (x - self.a[0])


@dataclass(frozen=True)
class Joined:
    """Two regions: "intersect" (the higher surface counts) or "union" (the lower one)."""

    how: str
    left: Segment | Joined
    right: Segment | Joined

    def height(self, x):
        """Height of the surface [m]."""
        return (np.maximum if self.how == "intersect" else np.minimum)(self.left.height(x), self.right.height(x))


def region(line: np.ndarray, reach: tuple[float, float] | None = None) -> Segment | Joined:
    """The side above a polyline of shape (n, 2) with rising x, continued straight to the ends of `reach`
    (default: its own). ValueError where half-spaces that count once cannot make it."""
    if len(line) == 2:
        return Segment(line[0], line[1])
    x = line[:, 0]
    ends = np.array(reach or (x[0], x[-1]))
    for k in sorted(range(1, len(line) - 1), key=lambda k: abs(2 * k - len(line))):  # the most even split first
        left, right = line[:k + 1], line[k:]
        before, after = np.append(x[:k], ends[0]), np.append(x[k + 1:], ends[1])
        above = np.concatenate([_straight_on(right, before) - _straight_on(line, before),
                                _straight_on(left, after) - _straight_on(line, after)])
        if (above <= 0).all() or (above >= 0).all():
            how = "intersect" if (above <= 0).all() else "union"
            return Joined(how, region(left, tuple(ends)), region(right, tuple(ends)))
    raise ValueError("the rock surface is too winding for LAMMPS' half-spaces: draw it with fewer points")


def _straight_on(chain: np.ndarray, x: np.ndarray) -> np.ndarray:
    """Heights of a polyline whose first and last segments go on."""
    inside = np.interp(x, chain[:, 0], chain[:, 1])
    first, last = Segment(chain[0], chain[1]), Segment(chain[-2], chain[-1])
    return np.where(x < chain[0, 0], first.height(x), np.where(x > chain[-1, 0], last.height(x), inside))


def bends(line: np.ndarray) -> np.ndarray:
    """The polyline without vertices at which it runs straight on: two half-spaces of one line would count a
    contact twice."""
    slope = np.diff(line[:, 1]) / np.diff(line[:, 0])
    return line[np.concatenate([[True], np.abs(np.diff(slope)) > 1e-9, [True]])]


def write(line: np.ndarray, path: Path) -> None:
    """Writes commands that define `region terrain`, the side above the polyline."""
    lines = ["# Written by slidewave: the side above the rock surface."]

    def define(part: Segment | Joined, name: str) -> str:
        if isinstance(part, Segment):
            (x0, z0), (x1, z1) = part.a, part.b
            lines.append(f"region {name} plane {x0:.12g} 0 {z0:.12g} {z0 - z1:.12g} 0 {x1 - x0:.12g} units box")
        else:
            left, right = define(part.left, name + "l"), define(part.right, name + "r")
            lines.append(f"region {name} {part.how} 2 {left} {right}")
        return name

    define(region(bends(line)), "terrain")
    path.write_text("\n".join(lines) + "\n")
