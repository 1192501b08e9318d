"""Drag of any stiffness x = K W/m with both real engines (cases/verification/suspension, held_bed).

Tolerances: momentum 1e-10 and mixture velocity 1e-6 are the solver's; Darcy's flow 1 % and an
overshoot of 2 % are what a user may expect of a bed at any step (DESIGN.md 4). Seen: 1e-11, 1e-9,
3e-4, 1 %."""

import math
import os
import unittest

import numpy as np

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

WINDOW = 1e-3
SPACING = 1e-3
FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class FreeSuspension(Verification):
    """Momentum stays, slip falls, all end at the mixture's velocity."""

    def comes_to_rest(self, phi: float, loading: float, x: float, windows: int = 40) -> None:
        diameter, density, speed = SPACING, 2650.0, 0.01
        eps = 1 - phi
        spacing = diameter * (math.pi / 6 / phi) ** (1 / 3)
        fluid = phi * density / (eps * loading)
        drag = x * density * spheres.volume(diameter) / WINDOW
        end = windows * WINDOW
        run = self.run_case(
            "suspension", parameters__spacing=spacing, parameters__fluid_density=fluid,
            parameters__fluid_viscosity=spheres.stokes_viscosity(drag, eps, diameter),
            coupling__smoothing_length=2.4 * spacing, case__end_time=end, output__interval=end,
            force=True)  # the check takes a fraction of 0.6 where a script leaves particles uncounted
        case = f"suspension, fraction {phi:g}, loading {loading:g}, K W/m {x:g}"
        v = run.history["one_vz_m_s"]
        first = phi * density * speed
        u = (first - phi * density * v) / (eps * fluid)  # were momentum kept: checked at the end
        end_u = run.field("U")[:, 2]
        momentum = (phi * density * v[-1] + eps * fluid * end_u.mean()) / first
        self.near(case, "momentum over the first", momentum, 1, 1e-10, run)
        self.budgets_close(case, run)
        slip = np.abs(v - u) / speed
        known = 1e-10 * (1 + loading)  # what the momentum demanded above says about the slip
        rise = float(np.diff(slip[slip > known]).max(initial=-1.0))
        self.near(case, "largest rise of the slip", max(0.0, rise), 0, known, run)
        if x * (1 + loading) >= 1:
            mixture = speed * loading / (1 + loading)
            self.near(case, "final velocity", v[-1], mixture, 1e-6, run)
            self.near(case, "final velocity of the fluid", end_u.mean(), mixture, 1e-6, run)

    def test_dense(self) -> None:
        self.comes_to_rest(0.3, 1, 1)
        self.comes_to_rest(0.3, 1, 1e4)

    def test_heavy(self) -> None:
        self.comes_to_rest(0.3, 1e3, 100)

    def test_light(self) -> None:
        self.comes_to_rest(0.01, 1e-3, 1e4)

    def test_mild_coupling_fails_here(self) -> None:
        """The mild coupling is refused by number, and wrong where it is forced: the remainder of what the
        fluid gave too much of comes back late, and the particles never catch up."""
        viscosity = spheres.stokes_viscosity(100 * 2650.0 * spheres.volume(SPACING) / WINDOW, 0.7, SPACING)
        settings = {"parameters__fluid_viscosity": viscosity, "coupling__regime": "mild"}
        self.run_case("suspension", expect=1, **settings)
        run = self.run_case("suspension", force=True, **settings)
        loading = 2650 * 0.303 / (1000 * 0.697)
        self.assertGreater(abs(run.history["one_vz_m_s"][-1] - 0.01 * loading / (1 + loading)), 1e-3)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for phi, loading in ((0.3, 1), (0.3, 1e3), (0.01, 1e-3), (0.01, 1), (0.01, 1e3), (0.5, 2)):
            for x in (1e-2, 1e-1, 1, 10, 1e2, 1e3, 1e4):
                self.comes_to_rest(phi, loading, x, 40 if x >= 1 else 100)


class HeldBed(Verification):
    """Darcy's flow through a bed whose contacts hold it, from rest and after a step of the pressure."""

    def settings(self, x: float, softness: float, ratio: float, diameter: float, windows: int) -> dict:
        """`softness`: x over k W^2/m. The load is a 1e-5 of the diameter in the contacts at most, the
        Reynolds number 1e-4 at most, so that Darcy's law is exact."""
        self.layers, self.diameter, fluid = 25, diameter, 1000.0
        self.eps = 1 - spheres.volume(diameter) / SPACING**3
        density = ratio * fluid
        mass = density * spheres.volume(diameter)
        drag = x * mass / WINDOW
        self.viscosity = spheres.stokes_viscosity(drag, self.eps, diameter)
        stiffness = x / softness * mass / WINDOW**2
        self.u = min(1e-4 * self.viscosity / (fluid * self.eps * diameter),
                     1e-5 * stiffness * diameter / drag)
        pressure = self.pressure(self.eps, self.u) / fluid
        steps = max(4, math.ceil(WINDOW / (0.15 * math.sqrt(mass / stiffness))))
        end = windows * WINDOW
        return {"parameters__diameter": diameter, "parameters__solid_density": density,
                "parameters__fluid_viscosity": self.viscosity,
                "parameters__contact_stiffness": stiffness, "parameters__dem_dt": WINDOW / steps,
                "parameters__pressure_first": pressure, "parameters__pressure_second": 2 * pressure,
                "parameters__step_time": end / 2, "case__end_time": end, "output__interval": end}

    def pressure(self, eps: np.ndarray | float, u: float) -> float:
        cells = np.broadcast_to(eps, self.layers)
        return spheres.darcy_pressure(cells, u * float(np.mean(cells)), SPACING, self.diameter, 1000.0,
                                      self.viscosity)

    def carries_darcys_flow(self, x: float, softness: float, ratio: float, windows: int = 30) -> None:
        run = self.run_case("held_bed",
                            **self.settings(x, softness, ratio, 1.001 * SPACING, windows))
        case = f"held bed, density ratio {ratio:g}, K W/m {x:g}, softness {softness:g}"
        flow = -run.probe("U")[:, 3] / self.u
        half = windows // 2
        self.budgets_close(case, run)
        self.near(case, "flow from rest over Darcy's", flow[half - 1], 1, 0.01, run)
        self.near(case, "flow after the step over Darcy's", flow[-1] / 2, 1, 0.01, run)
        if softness <= 0.01:  # else the bed's own compression adds to the flow
            overshoot = max(flow[:half].max(), flow[half:].max() / 2) - 1
            self.near(case, "overshoot", max(0.0, overshoot), 0, 0.02, run)

    def freed_settings(self, x: float, softness: float, ratio: float, windows: int) -> dict:
        """A gap of a twentieth of the spacing, and a flow that closes it in a dozen windows, then turns."""
        settings = self.settings(x, softness, ratio, 0.95 * SPACING, windows)
        self.u = 0.05 * SPACING / (12 * WINDOW)
        pressure = self.pressure(self.eps, self.u) / 1000.0
        return settings | {"parameters__pressure_first": pressure, "parameters__pressure_second": -pressure}

    def holds_frees_and_jams(self, x: float, softness: float, ratio: float, windows: int = 120) -> None:
        """Free spheres between frozen ones, with a gap: the flow jams them against the one side, lets
        go as it turns, and jams them against the other. While they are free the flow is twice Darcy's
        at most (they move with it); a jam may cost one window of another factor of two."""
        run = self.run_case("held_bed", **self.freed_settings(x, softness, ratio, windows))
        case = f"held, freed and jammed, density ratio {ratio:g}, K W/m {x:g}, softness {softness:g}"
        flow = -run.probe("U")[:, 3] / self.u
        half = windows // 2
        height = run.history["one_z_m"] - run.history["one_z_m"][0]
        self.budgets_close(case, run)
        self.assertLess(height[half], -0.04 * SPACING)
        self.assertGreater(height[-1], 0.04 * SPACING)
        self.near(case, "jammed flow over Darcy's", flow[half - 1], 1, 0.01, run)
        self.near(case, "jammed flow over Darcy's, turned", flow[-1], -1, 0.01, run)
        self.near(case, "largest flow over Darcy's, above 4", max(0, np.abs(flow).max() - 4), 0, 1e-9, run)

    def test_freed_and_jammed(self) -> None:
        self.holds_frees_and_jams(100, 0.01, 2.65)

    def test_stiff(self) -> None:
        self.carries_darcys_flow(100, 0.01, 2.65)

    def test_stiff_in_gas(self) -> None:
        self.carries_darcys_flow(1, 0.01, 1000)

    def test_stiffest(self) -> None:
        self.carries_darcys_flow(6e3, 1, 2.65, 80)  # 1e4 by the check, which takes 0.6 for the fraction

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for ratio in (1.5, 2.65, 20, 1000):
            for x, windows in ((0.1, 400), (1, 60), (10, 30), (100, 30), (1e3, 30)):
                self.carries_darcys_flow(x, 0.01, ratio, windows)
            self.carries_darcys_flow(6e3, 1, ratio, 80)
        for ratio in (1.5, 2.65, 1000):
            for x in (1, 10, 1e3):
                self.holds_frees_and_jams(x, 0.01, ratio)
        self.carries_darcys_flow(1e-2, 0.01, 20, 1000)
        self.carries_darcys_flow(6e3, 0.01, 2.65, 20)


if __name__ == "__main__":
    unittest.main()
