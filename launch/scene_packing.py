"""How densely the particles of a scene lie at first: share of space, and contacts of a particle."""

from __future__ import annotations

import itertools
import math

import numpy as np
from scipy.spatial import cKDTree

PROBES = 400  # particles around which the packing is looked at
REACH = 2.5  # lengths of the kernel beyond which it is nothing
TOUCHING = 1.001  # distance of two centres over their diameter, at most, that counts as a contact
MOST_IMAGES = 400_000


def solid_fraction(positions: np.ndarray, diameters: np.ndarray, length_m: float, box: np.ndarray) -> float | None:
    """Largest share of space by the kernel exp(-r2/L2)/(pi^1.5 L3) that the coupling smooths with, seen at
    up to PROBES of the particles. Directions in which the box (2, 3) is narrower than twice the
    kernel are continued periodically, as the kernel there is. None where that takes too many images."""
    images = _images(positions, box, REACH * length_m, box[1] - box[0] < 2 * length_m)
    if images is None:
        return None
    volumes = np.tile(math.pi / 6 * diameters**3, len(images) // len(positions))
    probes = positions[:: max(1, len(positions) // PROBES)]
    near = cKDTree(images).query_ball_point(probes, REACH * length_m)
    sums = [float(np.sum(volumes[k] * np.exp(-np.sum((images[k] - x) ** 2, axis=1) / length_m**2)))
            for k, x in zip(near, probes)]
    return max(sums) / (math.pi**1.5 * length_m**3)


def contacts(positions: np.ndarray, diameters: np.ndarray, box: np.ndarray, periodic: tuple[bool, ...]) -> float:
    """Number of others that a particle touches, the median of those that touch any; 0 where none does."""
    largest = float(diameters.max()) * TOUCHING
    images = _images(positions, box, largest, np.array(periodic))
    if images is None:
        return 0.0
    probes = range(0, len(positions), max(1, len(positions) // PROBES))
    sizes = np.tile(diameters, len(images) // len(positions))
    near = cKDTree(images).query_ball_point(positions[list(probes)], largest)
    counts = [np.count_nonzero(np.linalg.norm(images[k] - positions[i], axis=1)
                               <= TOUCHING * (sizes[k] + diameters[i]) / 2) - 1 for i, k in zip(probes, near)]
    touched = [c for c in counts if c > 0]
    return float(np.median(touched)) if touched else 0.0


def _images(positions: np.ndarray, box: np.ndarray, reach: float, repeated: np.ndarray) -> np.ndarray | None:
    """The particles and their images within `reach` along the repeated directions, the particles first."""
    width = box[1] - box[0]
    counts = [math.ceil(reach / w) if r and w > 0 else 0 for r, w in zip(repeated, width)]
    if math.prod(2 * n + 1 for n in counts) * len(positions) > MOST_IMAGES:
        return None
    shifts = sorted(itertools.product(*(range(-n, n + 1) for n in counts)), key=lambda s: any(s))
    return np.concatenate([positions + np.array(s) * width for s in shifts])
