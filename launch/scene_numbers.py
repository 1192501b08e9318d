"""Numbers of a prepared scene for slidewave_preflight: one flat table, SI units in the names."""

from __future__ import annotations

import math

from launch.case import Case
from launch.prepare import Prepared


def collect(case: Case, ready: Prepared) -> dict:
    """Known numbers only: what a scene does not tell is left out, and its check is skipped."""
    dem, mesh = ready.facts.dem, ready.facts.mesh
    numbers: dict[str, object] = {
        "window_s": case.get("coupling.window"),
        "end_time_s": case.get("case.end_time"),
        "gravity_m_s2": math.hypot(*case.get("physics.gravity")),
        "coarse_grain": case.get("parameters.coarse_grain"),
        "dem_dt_s": case.get("parameters.dem_dt"),
        "two_way": case.get("coupling.reaction") == "two_way",
        "smoothing_length_m": case.get("coupling.smoothing_length"),
        "stiffness_N_m": dem.stiffness_N_m,
        "particles": ready.facts.particles,
    }
    if dem.diameters is not None and dem.diameters.size:
        numbers["diameter_min_m"] = float(dem.diameters.min())
        numbers["diameter_max_m"] = float(dem.diameters.max())
    if dem.densities is not None and dem.densities.size:
        numbers["particle_density_min_kg_m3"] = float(dem.densities.min())
    if mesh is not None:
        numbers |= {"cells": mesh.cells, "cell_size_m": mesh.cell_size_m,
                    "smallest_cell_m": mesh.smallest_m}
    return {k: v for k, v in numbers.items() if v is not None}
