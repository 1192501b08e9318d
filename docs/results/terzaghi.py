#!/usr/bin/env python3
"""Regenerates terzaghi.csv and .svg beside this file: consolidation against mesh and window (minutes)

    /usr/bin/python3 docs/results/terzaghi.py

A column of 60 spheres on a floor takes up its own submerged weight, drained above only. Error: largest
difference of the settlement, over the final one, from Terzaghi's series for an initial pressure that
falls linearly to the top, U(T) = 1 - sum 4 (-1)^m/M^3 exp(-M^2 T), M = (2 m + 1) pi/2.
"""

from __future__ import annotations

import math
import os
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT), str(ROOT / "docs/results")]
os.environ.setdefault("SLIDEWAVE_BUILD", str(ROOT / "build"))

import curves  # noqa: E402
from tests.cases.stability.columns import OPEN_ABOVE, ROCK, WATER, D, lattice_settings, times  # noqa: E402
from tests.cases.stability.scene import Scene  # noqa: E402
from tests.cases.stability.trial import attempt  # noqa: E402
from tests.cases.verification import spheres  # noqa: E402

LAYERS, FIRST_WINDOW, RATE, STIFFNESS = 60, 2e-3, 1000.0, 1.25e8  # RATE: K/m [1/s]; STIFFNESS: kn/m [1/s2]


def consolidation(cells: int, cut: int) -> Scene:
    """The column on a mesh of `cells` cells, with the first window cut."""
    eps, mass, window = 1 - math.pi / 6, ROCK * spheres.volume(D), FIRST_WINDOW / cut
    kn = STIFFNESS * mass
    height, cv = LAYERS * D, (1 - math.pi / 6) ** 2 * D**2 * STIFFNESS / RATE
    windows = math.ceil(0.9 * height**2 / cv / FIRST_WINDOW) * cut
    weight = (ROCK - WATER) * spheres.volume(D) * 0.05
    final = weight / kn * LAYERS * (LAYERS + 1) / 2

    def error(history: dict[str, np.ndarray]) -> float:
        m = (2 * np.arange(100) + 1) * np.pi / 2
        t = cv * history["time_s"] / height**2
        degree = 1 - (4 * (-1.0) ** np.arange(100) / m**3 * np.exp(-np.outer(t, m**2))).sum(axis=1)
        return float(np.abs((history["one_z_m"][0] - history["one_z_m"]) / final - degree).max())

    cell = (4 * LAYERS / cells) ** (1 / 3) * D
    settings = lattice_settings(math.pi / 6, "sc", LAYERS) | times(window, windows) | OPEN_ABOVE | {
        "physics.gravity": "[0,0,-0.05]", "parameters.cells_up": cells, "parameters.contact_stiffness": kn,
        "parameters.fluid_viscosity": spheres.stokes_viscosity(RATE * mass, eps, D),
        "coupling.smoothing_length": max(2.4 * D, 1.6 * cell), "observe.one.id": 4 * LAYERS,
        "parameters.dem_dt": window / math.ceil(window / (0.25 / STIFFNESS**0.5)), "check.speed": 1e-3}
    return Scene("consolidation", f"{cells} cells, window {window:g} s", "column", settings, error=error)


def main() -> int:
    """Runs all points, writes both files."""
    rows = []
    for cells in (LAYERS // 4, LAYERS // 2, LAYERS, 2 * LAYERS):
        for cut in (1, 2, 4, 8):
            with tempfile.TemporaryDirectory() as place:
                seen = attempt(consolidation(cells, cut), Path(place).resolve() / "run")
            rows.append({"panel": "Terzaghi", "cells": cells, "window [s]": FIRST_WINDOW / cut, "error": seen.error,
                         "run time [s]": seen.wall_s, "check": seen.verdict})
            print(*rows[-1].values(), seen.why, flush=True)
    curves.write_csv("terzaghi", rows)
    curves.draw("terzaghi", rows, ["Terzaghi"], "run time [s]", "error", "cells", "60 spheres, window 2, 1, 0.5, 0.25 ms")
    return 0


if __name__ == "__main__":
    sys.exit(main())
