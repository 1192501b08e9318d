"""Particles that `create_atoms` puts on a lattice: where they are, before anything runs."""

from __future__ import annotations

import numpy as np

BASES = {"sc": [(0, 0, 0)], "bcc": [(0, 0, 0), (0.5, 0.5, 0.5)],
         "fcc": [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]}
MOST = 2_000_000  # points of a lattice that are worth counting


def positions(lattice: list[str], region: np.ndarray | None, box: np.ndarray | None) -> np.ndarray | None:
    """Points (N, 3) [m] of `lattice STYLE CONSTANT [origin X Y Z]`, whose words are given, in a block
    (2, 3) whose open sides are not finite, and in the box, both without their upper faces. None where it cannot
    be told: another style, orientation or spacing, no box, or too many points."""
    known = lattice and lattice[0] in BASES and lattice[2:3] in ([], ["origin"]) and len(lattice) in (2, 6)
    if not known or box is None or region is None or not np.isfinite(box).all():
        return None
    try:
        constant, origin = float(lattice[1]), np.array(lattice[3:6] or [0, 0, 0], dtype=float)
    except ValueError:
        return None
    bounded = np.where(np.isfinite(region), region, np.nan)
    low, high = np.fmax(bounded[0], box[0]), np.fmin(bounded[1], box[1])
    if not constant > 0 or np.prod((high - low) / constant + 1) > MOST:
        return None
    first, last = np.floor(low / constant) - 2, np.ceil(high / constant) + 1
    axes = [np.arange(a, b + 1) for a, b in zip(first, last)]
    corners = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 1, 3)
    points = (constant * (corners + np.array(BASES[lattice[0]]) + origin)).reshape(-1, 3)
    edge = 1e-9 * constant
    inside = ((points >= low - edge) & (points < high - edge)).all(axis=1)
    return points[inside]
