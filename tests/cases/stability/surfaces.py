"""Scenes at a free surface: into water, at its surface, in air, out of the domain. 1 mm spheres in
columns nine spheres wide, or boulders of 5 m."""

from __future__ import annotations

import math

from tests.cases.stability.columns import ROCK, WATER, D, times
from tests.cases.stability.scene import History, Scene
from tests.cases.verification import spheres


def pool(group: str, name: str, *, window: float = 5e-4, windows: int = 100, first: int = 30, layers: int = 4,
         ratio: float = 2.65, speed: float = 0.0, size: float = 1.0, allowed: float = 0.6,
         more: dict[str, object] | None = None, **fields) -> Scene:
    """Spheres of `size` mm above, at or in water 20 lattice cells deep under as much air; `first`: lattice cells
    below the lowest; `allowed`: speed that no sphere may pass; stiffness for impacts of a tenth of D at it."""
    diameter = size * D
    spacing, mass = 1.2 * diameter, ratio * WATER * spheres.volume(diameter)
    stiffness = mass / 2 * (allowed / (0.08 * diameter)) ** 2
    step = 0.3 * math.sqrt(mass / stiffness)
    settings = times(window, windows) | {
        "parameters.spacing": spacing, "parameters.diameter": diameter, "parameters.depth": 20 * spacing,
        "parameters.first": first, "parameters.layers": layers, "parameters.speed": speed,
        "parameters.solid_density": ratio * WATER, "parameters.contact_stiffness": stiffness,
        "parameters.damping": 0.2 * math.sqrt(stiffness / mass), "check.speed": allowed,
        "parameters.dem_dt": window / math.ceil(window / step), "parameters.fluid_dt": window} | (more or {})
    return Scene(group, name, "pool", settings, allowed, 9 * layers * mass, column="one_z_m", **fields)


def free_fall(history: History) -> float:
    """Speed in air over g t, whose drag is next to nothing in the first hundredths of a second."""
    return float(abs(-history["one_vz_m_s"][-1] / (9.81 * history["time_s"][-1]) - 1))


def stays(history: History) -> float:
    """How far a held sphere moved, over its diameter."""
    return float(abs(history["one_z_m"] - history["one_z_m"][0]).max() / D)


def bounce(group: str, name: str, *, overlap: float, **fields) -> Scene:
    """A sphere hits a floor, dry. The error is how far it sinks into it, over its diameter."""
    speed, mass, window = 1.0, ROCK * spheres.volume(D), 1e-4
    kn = mass * (speed / (overlap * D)) ** 2 / 2
    step = min(window / 2, 0.15 * math.sqrt(mass / kn))

    def error(history: History) -> float:
        return float(0.5 - history["one_z_m"].min() / D)

    settings = times(window, 60) | {
        "fluid.engine": "none", "parameters.spacing": 3 * D, "parameters.layers": 1, "parameters.up": 2,
        "parameters.across": 1, "parameters.filled": 1, "parameters.offset": 0.5, "parameters.ends_of_box": "f", "parameters.floor": 1,
        "parameters.speed": -speed, "parameters.contact_stiffness": kn, "check.speed": speed,
        "parameters.dem_dt": window / math.ceil(window / step)}
    return Scene(group, name, "column", settings, speed, mass, error, **fields)


def dam(group: str, name: str, *, fluid_dt: float, **fields) -> Scene:
    """A dam of 1 m breaks on dry ground: level at it in the end, by Ritter."""
    def error(history: History) -> float:
        return float(abs(history["dam_level_m"][-1] / (4 / 9) - 1))

    settings = {"coupling.window": 0.05, "parameters.fluid_dt": fluid_dt}
    return Scene(group, name, "dam_break", settings, error=error, **fields)


def sloshing(group: str, name: str, *, fluid_dt: float, **fields) -> Scene:
    """A tank that leans a little sloshes in its first mode; level at the gauge by linear theory."""
    omega = math.sqrt(9.81 * math.pi * math.tanh(math.pi / 2))

    def error(history: History) -> float:
        level, time = history["gauge_level_m"], history["time_s"]
        mean = 0.5 + 0.1 / 9.81 * (0.1667 - 0.5)
        wave = math.cos(math.pi * 0.1667) * 4 / math.pi**2 * 0.1 / 9.81
        theory = [mean + wave * math.cos(omega * t) for t in time]
        return float(abs(level - theory).max() / wave)

    window = max(0.02, fluid_dt)
    settings = times(window, round(2.4 / window)) | {"parameters.fluid_dt": fluid_dt}
    return Scene(group, name, "standing_wave", settings, error=error, **fields)
