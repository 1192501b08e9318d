"""Free surface: spheres that drop into water, and a standing wave."""

import math
import unittest

import numpy as np
from scipy.optimize import curve_fit

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification


class WaterEntry(Verification):
    """Level, pressure at the base and volumes after spheres have dropped into water."""

    def test_level_and_pressure(self) -> None:
        spacing, cells, depth, g = 1.2e-3, 60, 0.024, 9.81
        run = self.run_case("water_entry")
        number = run.summary["particles"]
        water, p = run.field("alpha.water"), run.field("p")
        rise = water.sum() * spacing - depth
        displaced = number * spheres.volume(1e-3) / (3 * spacing) ** 2
        self.assertEqual(number, 90)
        self.near("water_entry", "rise of the level [m]", rise, displaced, 0.005, run)
        # between the lowest cell and one in the middle of the bed's pores: rho g dz, not eps rho g dz
        base = (p[0] - p[8]) / (8 * spacing)
        self.near("water_entry", "pressure gradient in the bed [Pa/m]", base, 1000 * g, 1e-3, run)
        level = depth + displaced
        above = 1000 * g * (level - 0.5 * spacing) + 1.2 * g * (cells * spacing - level)
        self.near("water_entry", "pressure at the base [Pa]", p[0] - p[-1] + 0.5 * spacing * 1.2 * g, above,
                  0.01, run)
        for fluid, tolerance in (("water", 1e-6), ("air", 1e-4)):
            defect = run.history[f"{fluid}_volume_defect"].max()
            self.near("water_entry", f"{fluid} volume defect", defect, 0, tolerance, run)
        self.assertLess(np.abs(run.field("U")[:, 2]).max(), 1e-3, "all is still")
        self.budgets_close("water_entry", run)


class StandingWave(Verification):
    def test_frequency(self) -> None:
        length, depth, g = 1.0, 0.5, 9.81
        run = self.run_case("standing_wave")
        k = math.pi / length
        omega = math.sqrt(g * k * math.tanh(k * depth))
        time, level = run.history["time_s"], run.history["gauge_level_m"]

        def wave(t, mean, amplitude, rate, decay):
            return mean + amplitude * np.exp(-decay * t) * np.cos(rate * t)

        fit, _ = curve_fit(wave, time, level, p0=(depth, 0.003, 1.05 * omega, 0.0))
        self.near("standing_wave", "frequency by linear theory [1/s]", fit[2], omega, 0.02, run)


if __name__ == "__main__":
    unittest.main()
