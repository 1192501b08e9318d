"""Free surface: spheres that drop into water, still water in a bed, buoyancy of grains, a standing wave."""

import math
import os
import unittest

import numpy as np
from scipy.optimize import curve_fit

from launch import vtk_file
from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


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
        self.near("water_entry", "rise of the level at the gauge [m]", run.history["gauge_level_m"][-1] - depth,
                  displaced, 0.005, run)
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


class StillBed(Verification):
    """Nothing moves and the pressure is hydrostatic, to what the pressure's solver leaves over."""

    def stays(self, depth_cells: int, regime: str) -> None:
        spacing, cells, layers, g, rho, air = 1.2e-3, 40, 16, 9.81, 1000.0, 1.2
        run = self.run_case("still_bed", parameters__depth=depth_cells * spacing, coupling__regime=regime)
        cover = "covered" if depth_cells > layers else "half covered"
        case = f"still_bed, {cover}, {regime}"
        p = run.field("p")
        base = (depth_cells - 0.5) * spacing * g * rho + (cells - depth_cells) * spacing * g * air
        self.near(case, "largest velocity [m/s]", np.abs(run.field("U")).max(), 0, 1e-6, run)
        self.near(case, "pressure at the base [Pa]", p[0] - p[-1] + 0.5 * spacing * g * air, base, 1e-6, run)
        self.near(case, "level at the gauge [m]", run.history["gauge_level_m"][-1], depth_cells * spacing,
                  1e-6, run)
        self.assertLess(run.field("eps")[4], 0.5, "the base is in the bed")

    def test_covered(self) -> None:
        self.stays(30, "mild")

    def test_half_covered(self) -> None:
        self.stays(8, "stiff")

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        self.stays(30, "stiff")
        self.stays(8, "mild")


class SurfaceGrains(Verification):
    """Grains at rest through a surface, buoyancy over the water's from their first moment: 1 % beyond either
    fluid's at most. The rest is the pressure's solver, 1e-6; two-way the grains in air, a fraction of 0.005 there,
    fall meanwhile and speed it up by as much of g: 6e-6. Sum F dz says where the surface is felt: 0.01 of a cell."""

    def climbs(self, reaction: str, tolerance: float) -> None:
        g, end, ratio, cell, depth = 9.81, 5e-4, 1.2e-3, 1.2e-3, 0.024
        run = self.run_case("surface_grains", coupling__reaction=reaction)
        case = f"surface_grains, {reaction}"
        points = vtk_file.read_points(max(run.directory.glob("dem/particles_*.vtk"), key=lambda p: p.stat().st_mtime))
        order = np.argsort(points.positions[:, 2])
        z, force = points.positions[order, 2], 1 + points.data["velocity"][order, 2] / (g * end)
        low, high = (1 + run.history[f"{n}_vz_m_s"][-1] / (g * end) for n in ("lowest", "highest"))
        self.assertEqual(len(z), 55)
        self.near(case, "buoyancy deep in water", low, 1, tolerance, run)
        self.near(case, "buoyancy high in air", high, ratio, 0.01, run)
        self.near(case, "largest rise of buoyancy from a grain to the next above", max(0.0, np.diff(force).max()), 0,
                  tolerance, run)
        self.near(case, "beyond water's or air's", max(0.0, force.max() - 1, ratio - force.min()), 0, 0.01 * ratio,
                  run)
        share = np.sum((force[1:] + force[:-1] - 2 * ratio) / 2 * np.diff(z)) / (1 - ratio)
        self.near(case, "surface that the grains feel, cells from the water's", (z[0] + share - depth) / cell, 0,
                  0.01, run)

    def test_one_way(self) -> None:
        self.climbs("one_way", 1e-6)

    def test_two_way(self) -> None:
        self.climbs("two_way", 1e-5)


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
