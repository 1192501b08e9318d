"""Checks of a case beyond single keys: files exist, times fit each other, the scene is not empty."""

from __future__ import annotations

import math

from launch import places, ranks
from launch.case import Case

FLUID_FILES = ("system/controlDict", "system/fvSchemes", "system/fvSolution")


def is_multiple(value: float, step: float) -> bool:
    """Whether `value` is a whole number of `step`s, within 1e-9 of a step."""
    ratio = value / step
    return abs(ratio - round(ratio)) <= 1e-9 * max(1.0, ratio) and round(ratio) >= 1


def nearest_divisor(value: float, step: float) -> float:
    """The step closest to `step` of which `value` holds a whole number."""
    return value / max(1, round(value / step))


def check(case: Case) -> None:
    """Refuses missing files, times that do not fit, and a scene with neither fluid nor particles."""
    _check_files(case)
    _check_times(case)
    _check_optional(case)


def _check_optional(case: Case) -> None:
    """An engine that this machine lacks is named before anything starts."""
    name = ranks.DEM_PROGRAMS.get(case.get("dem.engine"), "")
    package = ranks.OPTIONAL_PACKAGES.get(name)
    if package and not places.program(name).is_file():
        raise case.error("dem.engine", f"{name} is not built: apt-get install --no-install-recommends "
                         f"{package}, then ./slidewave setup")


def _check_files(case: Case) -> None:
    if case.get("dem.engine") != "none":
        script = case.get("dem.script")
        if script is None:
            raise case.error("dem.script", "missing: the script that sets the particles up, e.g. "
                                           "\"dem/in.setup\"")
        if script.split("/")[0] != "dem":
            raise case.error("dem.script", "must lie in dem/, e.g. dem/in.setup")
        if not (case.directory / script).is_file():
            raise case.error("dem.script", f"no such file below {case.directory}")
    elif case.get("fluid.engine") == "none":
        raise case.error("dem.engine", "is none on both sides: the scene is empty")
    if case.get("fluid.engine") == "uniform_flow":
        _check_uniform_flow(case)
    if case.get("fluid.engine") != "openfoam":
        return
    for name in FLUID_FILES:
        if not (case.directory / "fluid" / name).is_file():
            raise case.error("fluid.engine", f"needs the file fluid/{name}, which is missing")
    mesh = (case.directory / "fluid/system/blockMeshDict").is_file()
    mesh = mesh or (case.directory / "fluid/constant/polyMesh/points").is_file()
    if not mesh and case.get("geometry") is None:
        raise case.error("fluid.engine", "has no mesh: add fluid/system/blockMeshDict, "
                                         "fluid/constant/polyMesh or a [geometry] table")


def _check_uniform_flow(case: Case) -> None:
    if case.get("coupling.reaction") != "one_way":
        raise case.error("coupling.reaction", "a prescribed flow (fluid.engine = \"uniform_flow\") takes no "
                                              "momentum from particles; write reaction = \"one_way\"")
    if case.get("dem.engine") == "none":
        raise case.error("dem.engine", "is none: a prescribed flow alone has nothing to work out")
    needed = ["density", "viscosity"]
    if case.get("uniform_flow.amplitude") is not None:
        needed.append("period")
    for name in needed:
        if case.get(f"uniform_flow.{name}") is None:
            raise case.error(f"uniform_flow.{name}", "missing: a prescribed flow needs it")


def _check_times(case: Case) -> None:
    window, end = case.get("coupling.window"), case.get("case.end_time")
    if window > end:
        raise case.error("coupling.window", f"is longer than case.end_time ({end:g} s)")
    if not is_multiple(end, window):
        raise case.error("case.end_time", f"must be a whole number of windows ({window:g} s); "
                                          f"e.g. {round(end / window) * window:.10g}")
    interval = case.get("output.interval")
    if interval is not None and not is_multiple(interval, window):
        wanted = max(1, round(interval / window)) * window
        raise case.error("output.interval", f"must be a whole number of windows ({window:g} s); "
                                            f"e.g. {wanted:.10g}")
    step = case.get("parameters.dem_dt")
    if step is not None and step > window * (1 + 1e-9):
        raise case.error("parameters.dem_dt", f"is longer than coupling.window ({window:g} s)")
    gravity = case.get("physics.gravity")
    if math.hypot(*gravity) > 1000:
        raise case.error("physics.gravity", "is above 1000 m/s2; give it in m/s2, e.g. [0, 0, -9.81]")
