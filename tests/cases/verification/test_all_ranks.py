"""Every case of cases/verification on 1:1, 2:1, 1:2 and 3:2 ranks, fluid : particles, for its first 20 windows.

Reference: the run on 1:1. Every decomposition starts with identical particles and fields, so what needs no solver (void
fraction, K, u_f) agrees to round-off, 1e-12. The pressure is solved to a residual of 1e-14: in a column of n cells that
leaves an error of up to 4 n 1e-14 of it (the Green's function of its ends), 1e-11 with the 256 of the longest case. That
gives 1e-10 for F at the start, where a lake's pressure is solved, and, added up over the 60 solves of 20 windows, 1e-9.
Contacts move too little here to make more of it.

u_f is compared with its largest value in the run, or what gravity makes of rest in a window; F (lift and virtual mass
within) with the largest of F and K u_f, which balance; K with its mean. Without particles the fluid's own fields are
compared, on 1, 2 and 3 ranks: saturation, pressure, and rho U, for air follows the water's errors 833 times faster."""

from __future__ import annotations

import io
import tempfile
import time
import tomllib
import unittest
from collections.abc import Callable
from contextlib import redirect_stdout
from pathlib import Path

import numpy as np

from launch import foam_mesh, verification
from launch.places import ROOT
from tests.cases import decompositions
from tests.cases.decompositions import DRAG, FORCE, LATER, VELOCITY

CASES = ROOT / "cases/verification"
WINDOWS = 20
RESIDUAL = 1e-14
ROUND_OFF, AT_START, AFTER = 1e-12, 1e-10, 1e-9
LAYOUTS = ((2, 1), (1, 2), (3, 2))

SETTINGS = {
    "held_bed": ["parameters.step_time=0.01"],  # the step of the pressure lies within the windows
    "slide_wave": ["parameters.gap=0"],  # the slide begins at the shore
    "surface_grains": ["coupling.reaction=two_way"],
    "water_entry": ["parameters.start=0.0216"],  # the lowest spheres touch the water
}
# Where a cut across the longest extent leaves ranks without particles: axis of the fluid's cuts, grid of two DEM ranks.
FLUID_CUTS = {"piston": 2, "slide_wave": 2, "submerged_collapse": 2}
DEM_CUTS = {"dam_break_grains": "1 2 1", "piston": "1 1 2", "slide_wave": "1 1 2", "still_bed": "2 1 1",
            "submerged_collapse": "1 1 2", "water_entry": "2 1 1"}

# Models that no case has as it stands: name of the test, case, settings.
STIRRED = ["coupling.regime=mild", "parameters.fluid_viscosity=1e-3", "parameters.noise=5e-5", "parameters.contact_stiffness=5"]
MORE = {
    "suspension_virtual_mass": ("suspension", [*STIRRED, "models.virtual_mass=zuber"]),
    "suspension_concurrent": ("suspension", [*STIRRED, "coupling.scheme=concurrent"]),
    "suspension_formulation_b": ("suspension", [*STIRRED, "models.formulation=B"]),
    "channel_lift": ("channel", ["models.viscous_force=false", "models.torque=none", "models.lift=saffman_mei",
                                 "coupling.reaction=two_way", "coupling.regime=mild", "coupling.smoothing_length=4e-3"]),
}
AFTER_OF = {
    # Water at rest: K follows 0.15 Re^0.68, steepest at no slip, where a u_f that is wrong by 1e-11 m/s makes this of it.
    ("still_bed", "K"): 6e-7,
    # Positions are known to 3e-18 m, forces of contacts of 100 N/m to 3e-16 N, 3e-9 of the drag, in each of 50 sub-steps.
    ("held_bed", "u_f"): 2e-7,
}


class Scene:
    """A case, what it couples, and its scales."""

    def __init__(self, name: str) -> None:
        case, more = MORE.get(name, (name, SETTINGS.get(name, [])))
        self.name = name
        self.directory = CASES / case
        data = tomllib.loads((self.directory / "case.toml").read_text())
        self.fluid_engine = data.get("fluid", {}).get("engine", "openfoam")
        self.particles = data.get("dem", {}).get("engine") != "none"
        self.parameters = data["parameters"]
        window = data["coupling"]["window"]
        self.fall = window * float(np.linalg.norm(data["physics"]["gravity"]))
        settings = [f"case.end_time={WINDOWS * window:.12g}", f"output.interval={window}", *more]
        self.words = [word for setting in settings for word in ("--set", setting)]

    def run(self, folder: Path, fluid: int, dem: int) -> None:
        with redirect_stdout(io.StringIO()):
            decompositions.prepare(self.directory, folder, fluid, dem, *self.words)
        if fluid > 1 and self.name in FLUID_CUTS:
            decompositions.cut_fluid(folder, FLUID_CUTS[self.name])
        if dem > 1 and self.name in DEM_CUTS:
            decompositions.cut_particles(folder, DEM_CUTS[self.name])
        decompositions.tighten(folder, RESIDUAL)
        decompositions.run(folder, fluid, dem if self.particles else 0, self.fluid_engine)

    def differences(self, one: Path, other: Path) -> dict[tuple[str, str], float]:
        """By quantity and stage."""
        found = self.of_particles(one, other) if self.particles else {}
        for quantity, value in self.stored().items():
            for stage, error in decompositions.worst_stored(one, other, WINDOWS, value).items():
                found[quantity, stage] = error
        return found

    def of_particles(self, one: Path, other: Path) -> dict[tuple[str, str], float]:
        rows = decompositions.answers(one)
        drag = np.abs(rows[:, DRAG, None] * rows[:, VELOCITY]).max()
        velocity = max(np.abs(rows[:, VELOCITY]).max(), self.fall)
        return decompositions.worst(one, other, WINDOWS, velocity, max(np.abs(rows[:, FORCE]).max(), drag))

    def stored(self) -> dict[str, Callable[[Path, int], np.ndarray]]:
        """Quantities of the fields that are compared."""
        if self.fluid_engine != "openfoam":
            return {}
        if self.particles:
            return {"void fraction": decompositions.void_fraction}
        field = decompositions.field
        lightness = self.parameters["air_density"] / self.parameters["water_density"]

        def momentum(folder: Path, number: int) -> np.ndarray:
            water = field(folder, number, "alpha.water")[:, None]
            return (water + (1 - water) * lightness) * field(folder, number, "U")

        return {"saturation": lambda folder, number: field(folder, number, "alpha.water"),
                "pressure": lambda folder, number: field(folder, number, "p_rgh"), "momentum": momentum}


def tolerance(case: str, quantity: str, stage: str) -> float:
    if stage == LATER:
        return AFTER_OF.get((case, quantity), AFTER)
    return AT_START if quantity == "F" else ROUND_OFF


class AllRanks(unittest.TestCase):
    def agree(self, name: str) -> None:
        scene = Scene(name)
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        base = Path(holder.name).resolve()
        start = time.monotonic()
        scene.run(base / "1_1", 1, 1)
        worst: dict[tuple[str, str], float] = {}
        layouts = LAYOUTS if scene.particles else ((2, 0), (3, 0))
        for fluid, dem in layouts:
            folder = base / f"{fluid}_{dem}"
            scene.run(folder, fluid, dem or 1)
            self.assertEqual(len(list(folder.glob("answers_*.bin"))), dem)
            if scene.particles:
                self.assertTrue(decompositions.all_have_particles(folder))
            if scene.fluid_engine == "openfoam":
                self.assertEqual(len(foam_mesh.parts(folder / "fluid")), fluid)
            for (quantity, stage), error in scene.differences(base / "1_1", folder).items():
                worst[quantity, stage] = max(worst.get((quantity, stage), 0.0), error)
                with self.subTest(ranks=f"{fluid}:{dem}", quantity=quantity, stage=stage):
                    self.assertLessEqual(error, tolerance(name, quantity, stage))
        others = ", ".join(f"{fluid}:{dem}" for fluid, dem in layouts)
        for (quantity, stage), error in worst.items():
            allowed = tolerance(name, quantity, stage)
            print(f"{name} {quantity} {stage}: {error:.1e} (tolerance {allowed:.0e})")
            verification.record(f"{name} on {others} ranks", f"{quantity} {stage}", error, 0, allowed,
                                time.monotonic() - start)


def _add_tests() -> None:
    for name in [*sorted(path.name for path in CASES.iterdir() if path.is_dir()), *MORE]:
        setattr(AllRanks, f"test_full_{name}", lambda self, name=name: self.agree(name))


_add_tests()

if __name__ == "__main__":
    unittest.main()
