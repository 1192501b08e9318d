"""Batch sedimentation with both real engines: the front of Kynch (1952), of a suspension and of a loose soil
whose trapped water carries its weight."""

import math
import os
import unittest

import numpy as np
from scipy.optimize import brentq

from tests.cases.verification import spheres
from tests.cases.verification.runs import Run, Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


def first_wave(fraction: np.ndarray, flux: np.ndarray) -> float:
    """Upward speed [m/s] of the fastest wave from the floor in a suspension of the first `fraction` that
    settles no more at the last: first side of the lower convex envelope of the flux (Kynch 1952; Rhee, Aris
    and Amundson 1986)."""
    return float(np.max((flux[0] - flux[1:]) / (fraction[1:] - fraction[0])))


class Batch(Verification):
    """Top of the suspension, until the first wave from below arrives, against the law of hindered settling.
    Its speed within 3 %: what single layers do to a straight line; its place within a kernel's length, so far
    that blurs the front. At first the water carries the whole submerged weight."""

    d, across, rho_s, rho_f, g, window = 1e-3, 1.03e-3, 2650.0, 1000.0, 9.81, 0.01

    def speed(self, fraction: float, mu: float) -> float:
        """Of a suspension in a closed column [m/s]."""
        eps, volume = 1 - fraction, spheres.volume(self.d)
        push = eps * (self.rho_s - self.rho_f) * self.g * volume
        return eps * brentq(lambda s: spheres.di_felice(eps, s, self.d, self.rho_f, mu) * s - push, 0, 10)

    def settles(self, first: float, layers: int) -> None:
        """`first`: solid fraction at the start."""
        rise = spheres.volume(self.d) / (self.across**2 * first)
        layer = math.sqrt(self.d**2 - self.across**2 / 2)
        last, height = first * rise / layer, layers * rise
        kernel = 1.55 * np.cbrt((2 * self.across) ** 2 * rise)
        mass = self.rho_s * spheres.volume(self.d)
        mu = spheres.stokes_viscosity(2 * mass / self.window, 1 - first, self.d)  # K W/m = 2
        fractions = np.linspace(first, last, 1000)
        flux = fractions * np.array([self.speed(f, mu) for f in fractions])
        flux[-1] = 0
        falls = self.speed(first, mu)
        until = height / (falls + first_wave(fractions, flux))
        end = self.window * math.ceil(until / self.window)
        run = self.run_case("batch", parameters__rise=rise, parameters__fluid_viscosity=mu, case__end_time=end,
                            parameters__layers=layers, coupling__smoothing_length=kernel, output__interval=end,
                            observe__top__id=4 * layers)
        case = f"batch, {layers} layers, fraction {first:g} to {last:.2g}"
        time, top = run.history["time_s"], run.history["top_z_m"]
        part = (time > 0.25 * until) & (time < 0.9 * until)
        way = top[0] - top
        self.near(case, "speed of the front [m/s]", np.polyfit(time[part], way[part], 1)[0], falls, 0.03, run)
        self.near(case, "front, kernels off its line", np.abs(way - falls * time)[part].max() / kernel, 0, 1, run)
        _, floor, lid = run.probe("p").T
        weight = (self.rho_s - self.rho_f) * self.g * first * height
        self.near(case, "pressure at the floor at first, over the submerged weight",
                  (floor - lid)[3] * self.rho_f / weight, 1, 0.03, run)
        self.budgets_close(case, run)

    def test_front(self) -> None:
        self.settles(0.25, 30)

    def test_compaction(self) -> None:
        self.settles(0.6, 60)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        self.settles(0.1, 60)
        self.settles(0.4, 60)
        self.settles(0.55, 120)


class TrappedWater(Verification):
    """A loose soil under water compacts. At first the water carries its whole submerged weight, in the end none of it.
    Level and water stay, to the solver. On a lattice: 3 % as above; 0.1 %: creep; the weight is borne until the top,
    which falls at the speed of hindered settling, comes to rest: 5 %, for the front's 3 % and the last layer. A random
    soil, at rest at random close packing (0.6366, Scott and Kilgour 1969; friction leaves 1 or 2 % less): 5 %, for its
    first grains touch in the time averaged over; 1 %: grains slip now and then. How long it is borne hangs there on
    the places of so few grains, by a third."""

    spacing, layers, cells, depth, d, mu, g, loose = 1.2395e-3, 20, 30, 0.029748, 1e-3, 5e-3, 9.81, 0.55

    def compacts(self, case: str, run: Run, at_first: float, in_the_end: float) -> tuple[float, float]:
        """Compares with these tolerances; gives the solid fraction at rest, off floor and top, and the time until a
        twentieth of the weight is left [s]."""
        area = (5 * self.spacing) ** 2
        self.assertEqual(run.summary["particles"], 1000)
        weight = 1650 * self.g * 1000 * spheres.volume(self.d) / area
        time, base, top = run.probe("p").T
        still = 1000 * self.g * (self.depth - self.spacing / 2) \
            + 1.2 * self.g * (self.cells * self.spacing - self.spacing / 2 - self.depth)
        excess = (base - top - still) / weight
        first = excess[(time > 0.01) & (time < 0.02)].mean()
        self.near(case, "excess pressure at the base at first, over the submerged weight", first, 1, at_first, run)
        self.near(case, "excess pressure at the base in the end, over the submerged weight", excess[-1], 0, in_the_end,
                  run)
        rise = run.history["gauge_level_m"] - self.depth
        self.near(case, "change of the level over the depth", np.abs(rise).max() / self.depth, 0, 1e-6, run)
        self.near(case, "water volume defect", run.history["water_volume_defect"].max(), 0, 1e-6, run)
        self.budgets_close(case, run)
        return 1 - run.field("eps")[3:10].mean(), time[excess > 0.05][-1]

    def test_submerged_weight(self) -> None:
        case, run = "trapped_water", self.run_case("trapped_water")
        dense, until = self.compacts(case, run, 0.03, 1e-3)
        push = (1 - self.loose) * 1650 * self.g * spheres.volume(self.d)
        slip = brentq(lambda s: spheres.di_felice(1 - self.loose, s, self.d, 1000.0, self.mu) * s - push, 0, 10)
        rest = self.layers * self.spacing * (1 - self.loose / dense) / ((1 - self.loose) * slip)
        self.near(case, "time until a twentieth of it is left [s]", until, rest, 0.05, run)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        run = self.run_case(str(self.packed("trapped_water")), parameters__grains="in.packed", parameters__friction=0.05)
        case = "trapped_water, random"
        dense, _ = self.compacts(case, run, 0.05, 0.01)
        self.near(case, "solid fraction at rest", dense, 0.6366, 0.025, run)


if __name__ == "__main__":
    unittest.main()
