"""A column of grains collapses under water: a probe of what the coupling is capable of.

Reference: Rondon, Pouliquen and Aussillous (2011), abstract: a loose column runs out far and fast over water under
positive pressure, a dense one half as far, slowly, under negative pressure. Held here: the dense column's sign, and
that it stays behind. Reported: the rest, for the pressure under the loose column is not positive here."""

import os
import unittest
from pathlib import Path

import numpy as np

from launch import verification, vtk_file
from tests.cases.verification.runs import Run, Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class SubmergedCollapse(Verification):
    """Columns of 1020 clumps of ten grain diameters, 60 mm long, seen for two seconds. Behind its gate a column presses
    and sucks no water, 1 % of its weight: what the pressure does later is the collapse's."""

    length, width, rho_s, rho_f, g = 0.06, 3.5485e-3, 2500.0, 1000.0, 9.81

    def collapses(self, case: Path, **settings: object) -> Run:
        run = self.run_case(str(case), parameters__grains="in.packed", **settings)
        self.assertEqual(run.summary["particles"], 1020)
        return run

    def fraction(self, run: Run) -> float:
        """Of the solid at first, a few diameters off the column's sides."""
        seen = vtk_file.read_points(run.directory / "dem/particles_0.vtk")
        (x, _, z), diameter = seen.positions.T, 2 * seen.data["radius"]
        inside = (x > 0.008) & (x < 0.052) & (z > 0.006) & (z < 0.038)
        return np.pi / 6 * (diameter[inside] ** 3).sum() / (0.044 * 0.032 * self.width)

    def excess(self, run: Run) -> tuple[np.ndarray, np.ndarray]:
        """Times, and pressure at the base of the column beyond that far off [Pa]."""
        time, under, far = run.probe("p").T
        return time, (under - far) * self.rho_f

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        fronts = {}
        for name, friction in (("dense", 0.0), ("loose", 0.5)):
            case, scene = self.packed("submerged_collapse", friction_packing=friction), f"submerged_collapse, {name}"
            held = self.collapses(case, parameters__held=1, case__end_time=0.1)
            run = self.collapses(case)
            time, pressure = self.excess(run)
            front = run.history["slide_front_x_m"] - self.length
            fronts[name] = front[-1]
            reported = {"fraction at first": self.fraction(run),
                        "pressure while held [Pa]": self.excess(held)[1][-1]}
            for first, last in ((0, 0.1), (0.1, 0.5), (0.5, 1), (1, 2)):
                reported[f"mean pressure, {first:g} to {last:g} s [Pa]"] = pressure[(time > first) & (time <= last)].mean()
            for end in (0.5, 1, 2):
                reported[f"run-out after {end:g} s [m]"] = np.interp(end, run.history["time_s"], front)
            for quantity, value in reported.items():
                print(f"{scene}: {quantity} {value:.4g}")
                verification.record(scene, quantity, float(value), None, None, run.wall_s)
            self.budgets_close(scene, run)
            if name == "dense":
                weight = (self.rho_s - self.rho_f) * self.g * 0.049 * reported["fraction at first"]
                self.near(scene, "pressure while held, over the submerged weight",
                          reported["pressure while held [Pa]"] / weight, 0, 0.01, held)
                early = max(reported["mean pressure, 0 to 0.1 s [Pa]"], reported["mean pressure, 0.1 to 0.5 s [Pa]"])
                self.near(scene, "mean pressure at first, above 0 [Pa]", max(0.0, early), 0, 1e-9, run)
        ratio = fronts["dense"] / fronts["loose"]
        print(f"submerged_collapse: run-out after 2 s, dense over loose {ratio:.3f}")
        verification.record("submerged_collapse", "run-out after 2 s, dense over loose", ratio, 0.5, None, run.wall_s)
        self.near("submerged_collapse", "run-out after 2 s, dense over loose, above 1", max(0.0, ratio - 1), 0, 1e-9, run)


if __name__ == "__main__":
    unittest.main()
