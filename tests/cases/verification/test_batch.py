"""Batch sedimentation with both real engines: the front of Kynch (1952), of a suspension and of a loose soil
whose trapped water carries its weight."""

import math
import os
import unittest

import numpy as np
from scipy.optimize import brentq

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

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
    """A loose soil under water compacts. At first the water carries its whole submerged weight, 3 % as above; in the
    end none of it, 0.1 %: creep. It is borne until the top, which falls at the speed of hindered settling, comes to
    rest: 5 %, for the front's 3 % and the last layer. Level and water stay, to the solver."""

    def test_submerged_weight(self) -> None:
        spacing, layers, cells, depth, d, mu, g, loose = 1.2395e-3, 20, 30, 0.029748, 1e-3, 5e-3, 9.81, 0.55
        run = self.run_case("trapped_water")
        area, volume = (5 * spacing) ** 2, spheres.volume(d)
        weight = 1650 * g * run.summary["particles"] * volume / area
        time, base, top = run.probe("p").T
        still = 1000 * g * (depth - spacing / 2) + 1.2 * g * (cells * spacing - spacing / 2 - depth)
        excess = (base - top - still) / weight
        case = "trapped_water"
        self.assertEqual(run.summary["particles"], 1000)
        first = excess[(time > 0.01) & (time < 0.02)].mean()
        self.near(case, "excess pressure at the base at first, over the submerged weight", first, 1, 0.03, run)
        self.near(case, "excess pressure at the base in the end, over the submerged weight", excess[-1], 0, 1e-3, run)
        dense = 1 - run.field("eps")[3:10].mean()
        push = (1 - loose) * 1650 * g * volume
        slip = brentq(lambda s: spheres.di_felice(1 - loose, s, d, 1000.0, mu) * s - push, 0, 10)
        rest = layers * spacing * (1 - loose / dense) / ((1 - loose) * slip)
        self.near(case, "time until a twentieth of it is left [s]", time[excess > 0.05][-1], rest, 0.05, run)
        level = run.history["gauge_level_m"]
        self.near(case, "change of the level over the depth", np.abs(level - depth).max() / depth, 0, 1e-6, run)
        self.near(case, "water volume defect", run.history["water_volume_defect"].max(), 0, 1e-6, run)
        self.budgets_close(case, run)


if __name__ == "__main__":
    unittest.main()
