"""coupling.scheme = "concurrent" with both real engines: a free suspension against its closed form.

With constant drag the slip decays as exp(-(K/m)(1 + M) t), M the mass loading, and the momentum stays.
Tolerances: the scheme is of first order, so halving the window halves the error (1.7 to 2.4: higher
orders still count at the coarsest); budgets as in every scheme. Beyond exp(-K W/m) = K W/m_fluid the
slip must ring, which is why the check refuses such scenes."""

import math
import unittest

import numpy as np

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

SPEED, DIAMETER, DENSITY, PHI = 1e-7, 1e-3, 2650.0, 0.3  # so slow that the drag is Stokes' to 2e-4
END = 0.02


class Concurrent(Verification):
    def suspension(self, scheme: str, rate: float, loading: float, window: float, force: bool = True, expect: int = 0):
        """rate: K/m [1/s]."""
        spacing = DIAMETER * (math.pi / 6 / PHI) ** (1 / 3)
        drag = rate * DENSITY * spheres.volume(DIAMETER)
        return self.run_case(
            "suspension", "--ranks-fluid", "1", "--ranks-dem", "1", parameters__spacing=spacing,
            parameters__fluid_density=PHI * DENSITY / ((1 - PHI) * loading),
            parameters__fluid_viscosity=spheres.stokes_viscosity(drag, 1 - PHI, DIAMETER),
            coupling__smoothing_length=2.4 * spacing, coupling__window=window, coupling__regime="mild",
            coupling__scheme=scheme, parameters__speed=SPEED, case__end_time=END, output__interval=END, force=force, expect=expect)

    def error(self, scheme: str, window: float) -> float:
        """Largest error of the particles' velocity over the first."""
        rate, loading = 50.0, 1.0
        run = self.suspension(scheme, rate, loading, window)
        self.budgets_close(f"suspension, {scheme}, window {window:g}", run)
        mixture = SPEED * loading / (1 + loading)
        exact = mixture + (SPEED - mixture) * np.exp(-rate * (1 + loading) * run.history["time_s"])
        return float(np.abs(run.history["one_vz_m_s"] - exact).max() / SPEED)

    def test_first_order(self) -> None:
        windows = (1e-3, 5e-4, 2.5e-4)
        errors = [self.error("concurrent", window) for window in windows]
        print("concurrent:", errors, "serial:", self.error("serial", windows[0]))
        self.assertLess(errors[0], 0.006)  # serial: 0.0046
        for coarse, fine in zip(errors, errors[1:]):
            self.assertGreater(coarse / fine, 1.7)
            self.assertLess(coarse / fine, 2.4)

    def test_rings_where_the_check_refuses(self) -> None:
        """K W/m = 0.5 and K W/m_fluid = 1.5: the slip turns in every window."""
        self.suspension("concurrent", 500.0, 3.0, 1e-3, force=False, expect=1)
        run = self.suspension("concurrent", 500.0, 3.0, 1e-3)
        self.budgets_close("suspension that rings, concurrent", run)
        change = np.diff(run.history["one_vz_m_s"])[1:9]
        self.assertTrue((change[1:] * change[:-1] < 0).all(), change)


if __name__ == "__main__":
    unittest.main()
