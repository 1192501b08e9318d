"""Three cases on 1:1, 2:1, 1:2 and 3:2 ranks, fluid : particles: settling, a bed, a free surface.

Reference: the run on 1:1. Every linear solver stops at a residual between 1e-14 and 1e-10, so that runs
may differ by that times the windows (DESIGN of the exchange: void fraction, K, u_f and F agree to
round-off); no contact is chaotic here."""

import unittest

import numpy as np

from tests.cases.decompositions import void_fraction
from tests.cases.verification.runs import Verification

LAYOUTS = ((2, 1), (1, 2), (3, 2))


class Ranks(Verification):
    def agree(self, case: str, columns: dict[str, float], tolerance: float, **settings: object) -> None:
        """`columns` of history.csv with the scale that differences are compared with."""
        one = self.run_case(case, "--ranks-fluid", "1", "--ranks-dem", "1", **settings)
        for fluid, dem in LAYOUTS:
            run = self.run_case(case, "--ranks-fluid", str(fluid), "--ranks-dem", str(dem), **settings)
            name = f"{case} on {fluid}:{dem} ranks"
            self.assertEqual(run.summary["ranks"], {"fluid": fluid, "dem": dem})
            for column, scale in columns.items():
                error = np.abs(run.history[column] - one.history[column]).max() / scale
                self.near(name, f"{column} against 1:1", error, 0, tolerance, run)
            self.near(name, "void fraction against 1:1",
                      np.abs(void_fraction(run.directory, -1) - void_fraction(one.directory, -1)).max(), 0, tolerance, run)
            self.budgets_close(name, run)

    def test_settling(self) -> None:
        self.agree("hindered_settling", {"one_vz_m_s": 1e-5, "one_z_m": 1e-3}, 1e-9)

    def test_bed(self) -> None:
        self.agree("seepage", {"one_z_m": 1e-3, "one_vz_m_s": 1e-3}, 1e-9, case__end_time=0.02,
                   output__interval=0.02)

    def test_free_surface(self) -> None:
        self.agree("water_entry", {"one_z_m": 1e-3, "one_vz_m_s": 0.1, "gauge_level_m": 1e-3}, 1e-9,
                   parameters__start=0.0216, case__end_time=0.02, output__interval=0.02)


if __name__ == "__main__":
    unittest.main()
