"""The section: one polyline from which wall, fluid mesh and slide are all made.

x points along the section and z up, in metres. `Section.height` is the only place where the
terrain's height is computed; the STL wall, the bottom of the fluid mesh and the failure surface
that the slide is packed on all come from it.
"""

import tomllib
from dataclasses import dataclass
from pathlib import Path

import numpy as np


@dataclass(frozen=True)
class Section:
    """Polylines of shape (n, 2) with rising x [m], and the lake level [m]."""

    failure: np.ndarray
    ground: np.ndarray
    bank: np.ndarray
    lake_level: float
    uphill_end: float  # x where the wall and the fluid mesh begin

    @property
    def wall(self):
        """Rock surface once the slide is gone, continued uphill along its first segment."""
        first, second = self.failure[0], self.failure[1]
        slope = (second[1] - first[1]) / (second[0] - first[0])
        start = [self.uphill_end, first[1] + slope * (self.uphill_end - first[0])]
        return np.vstack([start, self.failure, self.bank[1:]])

    @property
    def toe(self):
        return self.failure[-1]

    @property
    def bank_end(self):
        return self.bank[-1, 0]

    def height(self, x):
        """Height of the rock surface under the slide and the lake [m]."""
        return np.interp(x, self.wall[:, 0], self.wall[:, 1])

    def ground_height(self, x):
        """Height of the ground before the slide [m]; equals height() beyond the slide."""
        ground = np.interp(x, self.ground[:, 0], self.ground[:, 1])
        inside = (np.asarray(x) >= self.ground[0, 0]) & (np.asarray(x) <= self.toe[0])
        return np.where(inside, np.maximum(ground, self.height(x)), self.height(x))

    def slide_area(self):
        """Area between ground and failure surface [m2], exact (trapezia between all vertices)."""
        x = np.unique(np.concatenate([self.failure[:, 0], self.ground[:, 0]]))
        thickness = self.ground_height(x) - self.height(x)
        return float(np.sum(0.5 * (thickness[1:] + thickness[:-1]) * np.diff(x)))

    def shores(self):
        """x of each crossing of the rock surface with the lake level [m]."""
        x, z = self.wall[:, 0], self.wall[:, 1] - self.lake_level
        found = set(x[z == 0])
        for i in np.flatnonzero(z[:-1] * z[1:] < 0):
            found.add(x[i] + (x[i + 1] - x[i]) * z[i] / (z[i] - z[i + 1]))
        return sorted(found)


def read_section(path: Path, lake_level: float, uphill_margin: float, seat_shift: float = 0.0):
    """Reads a profile file. `uphill_margin` [m] is how far the wall goes on uphill of the crown;
    `seat_shift` [m] raises the seat of the failure surface by its `seat_weight`.

    Raises ValueError, naming the file, where the polylines do not fit together.
    """
    try:
        data = tomllib.loads(Path(path).read_text())
    except (OSError, tomllib.TOMLDecodeError) as error:
        raise ValueError(f"{path}: cannot be read: {error}") from error
    lines = {}
    for name in ("failure", "ground", "bank"):
        if name not in data:
            raise ValueError(f"{path}: the polyline '{name}' is missing")
        lines[name] = np.array(data[name], dtype=float)
        if lines[name].ndim != 2 or lines[name].shape[1] != 2 or len(lines[name]) < 2:
            raise ValueError(f"{path}: '{name}' must be a list of at least two [x, z]")
        if np.any(np.diff(lines[name][:, 0]) <= 0):
            raise ValueError(f"{path}: '{name}': x must rise from point to point")
    failure, ground, bank = lines["failure"], lines["ground"], lines["bank"]
    weight = np.array(data.get("seat_weight", np.zeros(len(failure))), dtype=float)
    if len(weight) != len(failure):
        raise ValueError(f"{path}: 'seat_weight' needs one number for each point of 'failure'")
    failure[:, 1] += seat_shift * weight
    for a, b, what in ((failure[0], ground[0], "'ground' must begin where 'failure' begins"),
                       (failure[-1], ground[-1], "'ground' must end where 'failure' ends"),
                       (failure[-1], bank[0], "'bank' must begin where 'failure' ends")):
        if not np.allclose(a, b):
            raise ValueError(f"{path}: {what}: {a} and {b}")
    inner = np.unique(np.concatenate([failure[:, 0], ground[:, 0]]))
    gap = np.interp(inner, *ground.T) - np.interp(inner, *failure.T)
    if np.any(gap < -1e-9):
        raise ValueError(f"{path}: the ground lies below the failure surface at x = "
                         f"{inner[np.argmin(gap)]:g}")
    return Section(failure, ground, bank, lake_level, failure[0, 0] - uphill_margin)
