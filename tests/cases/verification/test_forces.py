"""Forces beside drag with both real engines, against closed forms."""

import math
import os
import unittest

import numpy as np

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class VirtualMass(Verification):
    """A sphere in a fluid that speeds up, and free particles that slow down in fluid that they take along."""

    def follows(self, ratio: float, law: str, c: float) -> None:
        """v = a t (1 + C)/(rho_s/rho_f + C); 1e-6: the flow is uniform but for the inlet's cell, whose
        error has not come to the sphere's."""
        run = self.run_case("accelerated", parameters__solid_density=1000 * ratio, models__virtual_mass=law,
                            force=True)
        expected = 3.0 * (1 + c) / (ratio + c) * run.history["time_s"]
        error = np.abs(run.history["one_vz_m_s"] - expected).max() / expected[-1]
        self.near(f"accelerated fluid, rho_s/rho_f {ratio:g}, virtual mass {law}", "largest error of v(t)",
                  error, 0, 1e-6, run)

    def slows_down(self, law: str, x: float, window: float, tolerance: float) -> None:
        """Per volume eps rho u' = -B, phi rho_s v' = B, B = n (K (u - v) + C rho V (u' - v')): the slip falls
        at L n K/(1 + L C rho phi), L = 1/(eps rho) + 1/(phi rho_s). The closed form wants a K that stays:
        Stokes' coefficient, and so slow (Re 0.006) that Di Felice's exponent makes it 3e-4 less."""
        phi, d, rho_s, rho, speed, time_s = 0.303, 1e-3, 2650.0, 1000.0, 1e-5, 0.04
        eps = 1 - phi
        c = {"none": 0.0, "constant": 0.5, "zuber": 0.5 * (1 + 2 * phi) / (1 - phi)}[law]
        spacing = d * (math.pi / 6 / phi) ** (1 / 3)
        drag = x * rho_s * spheres.volume(d) / window
        run = self.run_case(
            "suspension", parameters__spacing=spacing, coupling__window=window, coupling__regime="mild",
            parameters__fluid_viscosity=spheres.stokes_viscosity(drag, eps, d), parameters__fluid_density=rho,
            parameters__speed=speed, coupling__smoothing_length=2.4 * spacing, models__virtual_mass=law,
            models__drag_coefficient="stokes", case__end_time=time_s, output__interval=time_s, force=True)
        both = 1 / (eps * rho) + 1 / (phi * rho_s)
        rate = both * phi / spheres.volume(d) * drag / (1 + both * c * rho * phi)
        mixture = phi * rho_s * speed / (phi * rho_s + eps * rho)
        v = mixture + (speed - mixture) * np.exp(-rate * run.history["time_s"])
        error = np.abs(run.history["one_vz_m_s"] - v).max() / (speed - mixture)
        case = f"suspension, virtual mass {law}, K W/m {x:g}"
        self.near(case, "largest error of v(t) over the fall", error, 0, tolerance, run)
        self.budgets_close(case, run)
        # Momentum of both, with what the particles have still to receive: none is lost. 1e-9: one particle
        # stands for all, and cells differ by what the solvers leave.
        owed = run.history["ledger_z_kg_m_s"][-1] / (64 * spacing**3)
        kept = phi * rho_s * run.history["one_vz_m_s"][-1] + eps * rho * run.field("U")[:, 2].mean() + owed
        self.near(case, "momentum over the first", kept / (phi * rho_s * speed), 1, 1e-9, run)

    def test_light_sphere_follows(self) -> None:
        self.follows(0.1, "constant", 0.5)

    def test_suspension(self) -> None:
        """0.5 %: the window's lag, first order in K W/m (halving the window halves it: full)."""
        self.slows_down("constant", 0.01, 5e-4, 0.005)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for ratio in (0.5, 1.0, 2.65):
            for law, c in (("none", 0.0), ("constant", 0.5)):
                self.follows(ratio, law, c)
        for law in ("none", "constant", "zuber"):
            self.slows_down(law, 0.01, 5e-4, 0.005)
            self.slows_down(law, 0.005, 2.5e-4, 0.0025)


if __name__ == "__main__":
    unittest.main()
