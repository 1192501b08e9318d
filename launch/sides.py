"""Checks that need the mesh and the particles: both sides cover the same space."""

from __future__ import annotations

import numpy as np

from launch.case import Case
from launch.errors import InputError
from launch.facts import AXES, Facts


def check(case: Case, facts: Facts) -> None:
    """Refuses an empty scene, particles outside the mesh, unequal periodic sides, a periodic width
    too small for the contact law, and a scaling that the law does not know."""
    _check_empty(case, facts)
    if case.get("dem.engine") == "none":
        return
    _check_width(case, facts)
    _check_scaling(case, facts)
    if facts.mesh is not None:
        _check_periodic(case, facts)
        _check_cover(case, facts)


def _check_empty(case: Case, facts: Facts) -> None:
    if facts.mesh is not None and facts.mesh.cells == 0:
        raise case.error("fluid.engine", "the mesh has no cell: the scene is empty")
    if case.get("fluid.engine") != "openfoam" and facts.particles == 0:
        raise case.error("dem.script", "makes no particle and there is no fluid case: the scene is "
                                       "empty; add create_atoms, read_data or fix insert")


def _check_width(case: Case, facts: Facts) -> None:
    largest, box = facts.largest_diameter_m, facts.dem.box
    if largest is None or box is None:
        return
    for axis in range(3):
        if not facts.dem.periodic[axis]:
            continue
        width, key = float(box[1, axis] - box[0, axis]), f"periodic width in {AXES[axis]}"
        script = case.directory / case.get("dem.script")
        if facts.dem.own_law and width <= largest:
            raise InputError(script, key, width, f"is not above the largest diameter ({largest:g} m): a "
                             "particle would touch its own image; make it wider")
        if not facts.dem.own_law and width < 2 * largest * (1 - 1e-9):
            raise InputError(script, key, width, f"is below two of the largest diameter ({largest:g} m): a "
                             f"pair would touch through both images; make it at least {2 * largest:g} m, or "
                             "take model linear, which tells images apart")


def _check_scaling(case: Case, facts: Facts) -> None:
    if case.get("models.contact_scaling") != "none" and not facts.dem.own_law:
        raise case.error("models.contact_scaling", "scales model linear only; take that contact law, or none")


def _check_periodic(case: Case, facts: Facts) -> None:
    script = case.directory / case.get("dem.script")
    for axis in range(3):
        name, particles, mesh = AXES[axis], facts.dem.periodic[axis], facts.mesh
        if mesh.cyclic[axis] and not particles:
            raise InputError(script, "boundary", "f", f"the sides disagree: the mesh is cyclic in {name}, "
                             f"the particles are not; write p for {name}")
        if particles and not (mesh.cyclic[axis] or mesh.flat[axis] or mesh.slab_axis == axis):
            raise InputError(script, "boundary", "p", f"the sides disagree: the particles are periodic in "
                             f"{name}, the mesh is not; make its patches cyclic, or write f for {name}")
        box = facts.dem.box
        if particles and mesh.cyclic[axis] and box is not None:
            if not np.allclose(box[:, axis], mesh.box[:, axis], atol=1e-6 * np.ptp(mesh.box[:, axis])):
                raise InputError(script, f"box in {name}", box[:, axis].tolist(), "the sides disagree: the "
                                 f"mesh is cyclic from {mesh.box[0, axis]:g} to {mesh.box[1, axis]:g} m")


def _check_cover(case: Case, facts: Facts) -> None:
    positions = facts.dem.positions
    if positions is None or not len(positions) or case.get("coupling.outside") != "error":
        return
    low, high = facts.mesh.box
    free = [k for k in range(3) if not facts.dem.periodic[k]]
    outside = ((positions < low) | (positions > high))[:, free].any(axis=1)
    if outside.any():
        worst = positions[int(np.argmax(outside))]
        raise case.error("coupling.outside", f"{int(outside.sum())} of {len(positions)} particles lie "
                         f"outside the mesh ({_box(facts.mesh.box)} m), e.g. one at "
                         f"({worst[0]:g} {worst[1]:g} {worst[2]:g}); extend the mesh or move them")


def _box(box: np.ndarray) -> str:
    return " x ".join(f"[{low:g}, {high:g}]" for low, high in box.T)
