"""Numbers of a prepared scene for slidewave_preflight: one flat table, SI units in the names, as
coupler/tools/facts.hpp lists them. What a scene does not tell is left out, and so is its check."""

from __future__ import annotations

import math
import os

import numpy as np

from launch import foam_dict, parameters, scene_packing
from launch.case import Case
from launch.facts import Facts
from launch.prepare import Prepared

USUAL_CONTACTS, USUAL_FRACTION = 5.0, 0.6  # what slidewave_preflight takes where nothing is known
LARGEST_FRACTION = 0.85  # the fluid's floor of the void fraction is 0.15


def collect(case: Case, ready: Prepared) -> dict[str, object]:
    """All known numbers of a scene."""
    numbers: dict[str, object] = {
        "window_s": case.get("coupling.window"),
        "end_time_s": case.get("case.end_time"),
        "gravity_m_s2": math.hypot(*case.get("physics.gravity")),
        "two_way": case.get("coupling.reaction") == "two_way",
        "regime": case.get("coupling.regime"),
        "scheme": case.get("coupling.scheme"),
        "drag": case.get("models.drag"),
        "drag_coefficient": case.get("models.drag_coefficient"),
        "formulation": case.get("models.formulation"),
        "virtual_mass": case.get("models.virtual_mass"),
        "speed_m_s": case.get("check.speed"),
        "held": case.get("check.held"),
        "ranks": ready.ranks_fluid + ready.ranks_dem,
        "memory_available_bytes": os.sysconf("SC_AVPHYS_PAGES") * os.sysconf("SC_PAGE_SIZE"),
    }
    if case.get("dem.engine") != "none":
        numbers |= _particles(case, ready.facts)
        numbers |= _packing(case, ready.facts)
    if ready.facts.mesh is not None:
        numbers |= _fluid(case, ready)
    if case.get("fluid.engine") == "uniform_flow":
        numbers |= {"fluid_density_kg_m3": case.get("uniform_flow.density"),
                    "fluid_viscosity_Pa_s": case.get("uniform_flow.viscosity")}
    return {k: v for k, v in numbers.items() if v is not None}


def _particles(case: Case, known: Facts) -> dict[str, object]:
    dem = known.dem
    numbers = {"particles": known.particles, "dem_dt_s": case.get("parameters.dem_dt"),
               "coarse_grain": max(case.get("models.coarse_grain_by_type")  # the finest grains answer fastest
                                   or [case.get("parameters.coarse_grain") or 1]),
               "stiffness_N_m": dem.stiffness_N_m,
               "tangential_stiffness_N_m": dem.tangential_stiffness_N_m,
               "contact_law": "own" if dem.own_law else "packaged",
               "contact_scaling": case.get("models.contact_scaling")}
    if dem.diameters is not None and dem.diameters.size:
        numbers["diameter_min_m"] = float(dem.diameters.min())
        numbers["diameter_max_m"] = float(dem.diameters.max())
    if dem.densities is not None and dem.densities.size:
        numbers["particle_density_min_kg_m3"] = float(dem.densities.min())
    if dem.box is not None and any(dem.periodic):
        numbers["periodic_width_m"] = float(min(np.ptp(dem.box, axis=0)[list(dem.periodic)]))
    if dem.positions is not None and len(dem.positions) > 1 and dem.diameters is not None:
        numbers["column_height_m"] = _column_height(case, dem.positions, float(dem.diameters.max()))
    return numbers


def _packing(case: Case, known: Facts) -> dict[str, object]:
    """What the particles' places at first tell: contacts of one, and the densest part where that is
    more than what the check takes for granted (settling brings any crowd to 0.6)."""
    dem = known.dem
    if dem.positions is None or dem.diameters is None or len(dem.positions) < 2 or dem.box is None:
        return {}
    if not np.isfinite(dem.box).all():
        return {}
    numbers: dict[str, object] = {}
    touched = scene_packing.contacts(dem.positions, dem.diameters, dem.box, dem.periodic)
    if touched > USUAL_CONTACTS:
        numbers["contact_number"] = touched
    length = case.get("coupling.smoothing_length")
    if length is not None:
        dense = scene_packing.solid_fraction(dem.positions, dem.diameters, length, dem.box)
        if dense is not None and dense > USUAL_FRACTION:
            numbers["solid_fraction"] = min(dense, LARGEST_FRACTION)
    return numbers


def _column_height(case: Case, positions: np.ndarray, diameter_m: float) -> float:
    """Height of the highest column of particles [m], columns two diameters wide."""
    gravity = np.array(case.get("physics.gravity"), dtype=float)
    up = int(np.argmax(np.abs(gravity)))
    across = [k for k in range(3) if k != up]
    cell = np.floor(positions[:, across] / (2 * diameter_m)).astype(int)
    _, column = np.unique(cell, axis=0, return_inverse=True)
    low = np.full(column.max() + 1, np.inf)
    high = np.full(column.max() + 1, -np.inf)
    np.minimum.at(low, column, positions[:, up])
    np.maximum.at(high, column, positions[:, up])
    return float((high - low).max()) + diameter_m


def _fluid(case: Case, ready: Prepared) -> dict[str, object]:
    mesh, place = ready.facts.mesh, ready.directory / "fluid"
    values = {k: v for k, v in parameters.common_values(case).items()}
    numbers: dict[str, object] = {"cells": mesh.cells, "cell_size_m": mesh.cell_size_m,
                                  "smallest_cell_m": mesh.smallest_m}
    if case.get("coupling.reaction") == "two_way":
        numbers["smoothing_length_m"] = case.get("coupling.smoothing_length")
    transport = foam_dict.expanded(place / "constant/transportProperties", values)
    phases = (foam_dict.entry(transport, "phases") or "").strip("()").split()
    blocks = [foam_dict.block(transport, name) for name in phases] or [transport]
    fluids = [(rho, nu) for text in blocks if (rho := foam_dict.number(text, "rho")) is not None
              and (nu := foam_dict.number(text, "nu")) is not None]
    if fluids:
        dense = max(fluids)
        numbers |= {"fluid_density_kg_m3": dense[0], "fluid_viscosity_Pa_s": dense[0] * dense[1]}
    if len(fluids) > 1:
        light = min(fluids)
        numbers |= {"second_density_kg_m3": light[0], "second_viscosity_Pa_s": light[0] * light[1]}
        numbers["surface_tension_N_m"] = foam_dict.number(transport, "sigma")
    control = foam_dict.expanded(place / "system/controlDict", values)
    if foam_dict.entry(control, "adjustTimeStep") in ("no", "off", "false", None):
        numbers["fluid_dt_s"] = foam_dict.number(control, "deltaT")
    return numbers
