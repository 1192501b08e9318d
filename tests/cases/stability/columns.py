"""Scenes in one fluid, each with its closed form: suspensions, settling, held beds, piles, lone spheres.

Lengths in m, W the window [s], x = K W/m the drag's response in it; drag laws are those that
tests/cases/verification/spheres.py writes down from the publications."""

from __future__ import annotations

import math

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from tests.cases.stability.scene import History, Scene
from tests.cases.verification import spheres

D = 1e-3
START = 3  # windows in which an impulsive start may be smeared
ROCK, WATER = 2650.0, 1000.0
PER_CELL = {"sc": 1, "fcc": 4}
CLOSED = {"parameters.ends": "patch", "parameters.ends_of_box": "f", "parameters.floor": 1,
          "parameters.bottom_u": "fixedValue",
          "parameters.bottom_p": "zeroGradient", "parameters.top_u": "fixedValue",
          "parameters.top_p": "zeroGradient"}
OPEN_ABOVE = CLOSED | {"parameters.top_u": "zeroGradient", "parameters.top_p": "fixedValue"}
OPEN = OPEN_ABOVE | {"parameters.bottom_u": "zeroGradient", "parameters.bottom_p": "fixedValue"}


def spacing_of(phi: float, lattice: str, diameter: float = D) -> float:
    """Lattice constant at which spheres take the share `phi` of space."""
    return (PER_CELL[lattice] * spheres.volume(diameter) / phi) ** (1 / 3)


def lattice_settings(phi: float, lattice: str, layers: int) -> dict[str, object]:
    """A column filled with spheres, one mesh cell a lattice cell; the lowest do not touch a floor."""
    spacing = spacing_of(phi, lattice)
    return {"parameters.lattice": lattice, "parameters.spacing": spacing, "parameters.up": layers,
            "parameters.layers": layers, "parameters.cells_up": layers,
            "coupling.smoothing_length": 2.4 * spacing, "parameters.offset": 0.5 if lattice == "sc" else 0.36}


def soft(mass: float, window: float, phi: float, lattice: str) -> float:
    """Contact stiffness [N/m] whose wave runs seven tenths of a kernel in a window, for spheres that do not
    touch anyway."""
    return 0.5 * mass * (2.4 * spacing_of(phi, lattice) / D / window) ** 2


def times(window: float, windows: int) -> dict[str, object]:
    """Window and end."""
    return {"coupling.window": window, "case.end_time": window * windows, "output.interval": window * windows}


def suspension(group: str, name: str, *, phi: float = 0.3, ratio: float = 2.65, x: float | None = None,
               viscosity: float | None = None, lattice: str = "sc", window: float = 1e-3, windows: int = 40,
               density: float = ROCK, more: dict[str, object] | None = None, **fields) -> Scene:
    """Particles at 1 cm/s in a periodic column come to rest with fluid that was at rest: slip by the law."""
    eps, speed, layers = 1 - phi, 0.01, 16
    fluid, mass = density / ratio, density * spheres.volume(D)
    if viscosity is None:
        viscosity = spheres.stokes_viscosity(x * mass / window, eps, D)
    loading = phi * density / (eps * fluid)

    def error(history: History) -> float:
        def slows(_: float, slip: np.ndarray) -> list[float]:
            return [-spheres.di_felice(eps, slip[0], D, fluid, viscosity) / mass * (1 + loading) * slip[0]]

        t = history["time_s"]
        slip = solve_ivp(slows, (0, t[-1]), [speed], t_eval=t, method="LSODA", rtol=1e-8, atol=1e-12).y[0]
        late = slice(START, None)
        return float(np.abs(history["one_vz_m_s"] - (loading * speed + slip) / (1 + loading))[late].max() / speed)

    settings = lattice_settings(phi, lattice, layers) | times(window, windows) | {
        "parameters.solid_density": density, "parameters.fluid_density": fluid,
        "parameters.fluid_viscosity": viscosity, "parameters.speed": speed, "check.speed": speed,
        "parameters.contact_stiffness": soft(mass, window, phi, lattice),
        "parameters.dem_dt": window / 40} | (more or {})
    count = 4 * layers * PER_CELL[lattice]
    return Scene(group, name, "column", settings, speed, count * mass, error, **fields)


def settling(group: str, name: str, *, phi: float = 0.3, ratio: float = 2.65, x: float = 1.0,
             lattice: str = "sc", window: float = 1e-3, least: int = 20, noise: float = 0.0,
             more: dict[str, object] | None = None, **fields) -> Scene:
    """Particles fall (or rise) in a closed column, the fluid goes the other way: speed by the law. Gravity is
    such that they fall a hundredth of their diameter at most: they do not reach the floor, or each other.
    `least`: windows; `noise`: random displacement at first, in diameters."""
    eps, layers = 1 - phi, 24
    density = ROCK if ratio >= 1 else ratio * WATER
    fluid = density / ratio
    mass = density * spheres.volume(D)
    viscosity = spheres.stokes_viscosity(x * mass / window, eps, D)
    windows = math.ceil(max(least, 8 / x * eps**2 * (1 + phi / (eps * ratio))))
    heavier = density - fluid if ratio != 1 else 0.2 * fluid  # at 1 nothing may move
    drag = x * mass / window
    gravity = min(1.0, 0.01 * D / (windows * window) * drag / (eps * abs(heavier) * spheres.volume(D)))
    slip = eps * abs(heavier) * gravity * spheres.volume(D) / drag

    def error(history: History) -> float:
        law = eps * slip * ((ratio > 1) - (ratio < 1))
        return float(abs(-history["one_vz_m_s"][-1] - law) / (eps * slip))

    settings = lattice_settings(phi, lattice, layers) | times(window, windows) | CLOSED | {
        "physics.gravity": f"[0,0,{-gravity!r}]", "parameters.solid_density": density,
        "parameters.fluid_density": fluid, "parameters.fluid_viscosity": viscosity,
        "parameters.contact_stiffness": soft(mass, window, phi, lattice),
        "parameters.noise": noise * D, "check.speed": 2 * slip, "observe.one.id": 2 * layers * PER_CELL[lattice] + 1,
        "parameters.dem_dt": window / 40} | (more or {})
    count = 4 * layers * PER_CELL[lattice]
    return Scene(group, name, "column", settings, 2 * slip, count * mass, error, **fields)


def held(group: str, name: str, *, x: float, ratio: float = 2.65, softness: float = 0.01, lattice: str = "sc",
         phi: float | None = None, frozen: bool = False, windows: int = 30, window: float = 1e-3,
         more: dict[str, object] | None = None, **fields) -> Scene:
    """A pressure difference drives fluid through a bed of which every other layer is held and holds the
    rest by its contacts (or all is): Darcy's flow by the law. softness = K/(k W), k of a contact."""
    nearest = 1.0 if lattice == "sc" else 1 / math.sqrt(2)
    diameter = 1.001 * D
    across, layers = (2, 13) if lattice == "fcc" else (3, 25)
    spacing = D / nearest if phi is None else spacing_of(phi, lattice, diameter)
    eps = 1 - PER_CELL[lattice] * spheres.volume(diameter) / spacing**3
    mass = ratio * WATER * spheres.volume(diameter)
    drag = x * mass / window
    viscosity = spheres.stokes_viscosity(drag, eps, diameter)
    stiffness = x / softness * mass / window**2
    u = min(1e-4 * viscosity / (WATER * eps * diameter), 1e-5 * stiffness * diameter / drag)
    number = (1 - eps) / spheres.volume(diameter)
    pressure = layers * spacing * number * drag * u / eps / WATER

    def error(history: History) -> float:
        flow = -history["flow"] / u
        return float(max(abs(flow[-1] - 1), flow.max() - 1.5 if softness <= 0.01 else 0.0))

    steps = max(4, math.ceil(window / (0.12 * math.sqrt(mass / stiffness))))
    settings = lattice_settings(0.5, lattice, layers) | times(window, windows) | OPEN | {
        "parameters.spacing": spacing, "coupling.smoothing_length": 3.2 * D, "parameters.diameter": diameter,
        "parameters.across": across, "parameters.filled": across,
        "parameters.held": 2 if frozen else 1, "parameters.solid_density": ratio * WATER,
        "parameters.fluid_viscosity": viscosity, "parameters.contact_stiffness": stiffness,
        "parameters.pressure": pressure, "parameters.dem_dt": window / steps,
        "observe.one.id": 1, "check.speed": max(u, 1e-9), "check.held": True} | (more or {})
    return Scene(group, name, "column", settings, 10 * u, across**2 * layers * PER_CELL[lattice] * mass / 2, error, **fields)


def pile(group: str, name: str, *, kn: float, diameter: float = 5.0, window: float, windows: int,
         layers: int = 8, step: float | None = None, damping: float = 1.0, fluid: float = WATER, viscosity: float = 1e-3,
         lattice: str = "sc", gap: float = 0.0, more: dict[str, object] | None = None, **fields) -> Scene:
    """Touching columns of boulders on a floor under water take up their submerged weight. The error
    is how far spheres that should touch lie in each other, over their diameter. `step` and `damping` over
    sqrt(m/kn) and its inverse (step: 0.3, or 0.2 where twelve touch each); `gap` between the spheres at first,
    over the diameter."""
    gravity, mass = 9.81, ROCK * spheres.volume(diameter)
    weight = (ROCK - fluid) * spheres.volume(diameter) * gravity
    spacing = diameter * (1 + gap) * (1 if lattice == "sc" else math.sqrt(2))
    beat = math.sqrt(mass / kn)
    fall = weight / kn * layers * (layers + 1) / 2 + gap * diameter * layers
    steps = math.ceil(window / ((step or (0.3 if lattice == "sc" else 0.2)) * beat))

    def error(history: History) -> float:
        return float(history["max_overlap"].max())

    settings = lattice_settings(0.5, lattice, layers) | times(window, windows) | OPEN_ABOVE | {
        "physics.gravity": f"[0,0,{-gravity}]", "parameters.diameter": diameter, "parameters.spacing": spacing,
        "coupling.smoothing_length": 2.4 * spacing, "parameters.contact_stiffness": kn,
        "parameters.up": layers + 4, "parameters.cells_up": layers + 4,
        "parameters.fluid_density": fluid, "parameters.fluid_viscosity": viscosity,
        "parameters.damping": damping / beat, "parameters.dem_dt": window / steps,
        "check.speed": 2 * math.sqrt(2 * gravity * fall)} | (more or {})
    return Scene(group, name, "column", settings, math.sqrt(2 * gravity * fall),
                 4 * layers * PER_CELL[lattice] * mass, error, **fields)


def lone(group: str, name: str, *, cell: float = 1.0, kernel: float = 6.0, cells: int = 10, x: float = 0.05,
         ratio: float = 2.65, window: float = 1e-3, windows: int = 120, offset: float = 0.5, closed_form: bool = True,
         more: dict[str, object] | None = None, **fields) -> Scene:
    """One sphere falls in a closed box of `cells` cells an edge, each `cell` diameters, at a Reynolds number
    of 0.01: terminal speed of the law in fluid at rest. `kernel`: smoothing length over the diameter."""
    edge, density = cell * cells * D, ratio * WATER
    mass = density * spheres.volume(D)
    viscosity = x * mass / window / (3 * math.pi * D)
    gravity = 0.01 * viscosity / (WATER * D) * x / window * ratio / abs(ratio - 1)
    speed = 0.01 * viscosity / (WATER * D)

    def law(s: float) -> float:
        return 3 * math.pi * viscosity * D * spheres.brown_lawler_cd_re(WATER * D * s / viscosity) / 24

    terminal = brentq(lambda s: law(s) * s - abs(ratio - 1) * WATER * gravity * spheres.volume(D), 1e-3 * speed, 10 * speed)

    def error(history: History) -> float:
        return float(abs(abs(history["one_vz_m_s"][-1]) / terminal - 1))

    settings = times(window, windows) | CLOSED | {
        "physics.gravity": f"[0,0,{-gravity!r}]", "parameters.spacing": edge, "parameters.across": 1, "parameters.up": 1,
        "parameters.filled": 1, "parameters.layers": 1, "parameters.offset": offset,
        "parameters.cells_up": cells, "parameters.cells_across": cells, "parameters.solid_density": density,
        "parameters.fluid_viscosity": viscosity, "coupling.smoothing_length": kernel * D,
        "check.speed": speed, "parameters.dem_dt": window / 40} | (more or {})
    return Scene(group, name, "column", settings, 3 * speed, mass, error if closed_form else None, **fields)
