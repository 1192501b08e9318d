"""LAMMPS in LIGGGHTS' place beside OpenFOAM: same case, another dem.engine, the same answer.

settling_sphere against the ODE and against LIGGGHTS; then a bed of touching spheres that rests on the floor
while water rises through it: drag and contacts hold it, so all of gather, kick, ledger and answer take part."""

import time
import unittest

import numpy as np

from launch import results, verification
from launch.places import ROOT
from tests.cases.settling_ode import Sphere
from tests.launch.scratch import ScratchCase

SPHERE = Sphere(2e-3, 2500, 1000, 0.25)
LAMMPS = ("--set=dem.engine=lammps", "--set=dem.script=dem/in.lammps")

BLOCKS = """FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }
vertices ((0 0 0) (0.02 0 0) (0.02 0.02 0) (0 0.02 0) (0 0 0.04) (0.02 0 0.04) (0.02 0.02 0.04) (0 0.02 0.04));
blocks (hex (0 1 2 3 4 5 6 7) (5 5 10) simpleGrading (1 1 1));
boundary ( inlet { type patch; faces ((0 3 2 1)); } outlet { type patch; faces ((4 5 6 7)); }
  sides { type wall; faces ((0 1 5 4) (1 2 6 5) (2 3 7 6) (3 0 4 7)); } );
"""
VELOCITY = """FoamFile { version 2.0; format ascii; class volVectorField; object U; }
dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0.002);
boundaryField { inlet { type fixedValue; value uniform (0 0 0.002); }
  outlet { type zeroGradient; } sides { type slip; } }
"""
PRESSURE = """FoamFile { version 2.0; format ascii; class volScalarField; object p; }
dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { inlet { type zeroGradient; } outlet { type fixedValue; value uniform 0; }
  sides { type zeroGradient; } }
"""
BOX = "region          box block -0.03 0.03 -0.03 0.03 0 0.08 units box"
ONE = "create_atoms    1 single 0.001 0.001 ${start_height} units box"
# 6 x 6 columns of 5 spheres, a hair apart in the plane: each column stands by normal contacts alone.
BED = "\n".join(f"create_atoms 1 single {x:.6g} {y:.6g} {z:.6g} units box" for z in np.arange(5) * 2e-3 + 1e-3
                for y in np.arange(6) * 3e-3 + 2.5e-3 for x in np.arange(6) * 3e-3 + 2.5e-3)


class Lammps(ScratchCase):
    def run_case(self, name: str, *more: str) -> dict[str, np.ndarray]:
        out, start = self.place / name, time.monotonic()
        _, text, err = self.slidewave("run", self.case, "--out", out, *more)
        self.wall_s = time.monotonic() - start
        self.summary = results.read_summary(out)
        self.assertEqual(self.summary.get("status"), "completed", text + err)
        return results.read_history(out)

    def same(self, what: str, found: dict[str, np.ndarray], expected: dict[str, np.ndarray],
             names: tuple[str, ...]) -> None:
        """Within 1e-6 of the largest value of each column."""
        self.assertEqual(list(found), list(expected))
        for name in names:
            error = float(np.abs(found[name] - expected[name]).max() / np.abs(expected[name]).max())
            verification.record(f"{what}, LAMMPS", f"{name} against LIGGGHTS, relative", error, 0, 1e-6,
                                self.wall_s)
            self.assertLess(error, 1e-6, name)

    def test_settling_against_the_ode(self) -> None:
        for variant, ranks in (("one_way", "1"), ("stiff", "2")):
            found = self.run_case(variant, "--variant", variant, *LAMMPS, "--ranks-dem", ranks)
            viscosity = 2.5 if variant == "stiff" else 0.25
            sphere = Sphere(2e-3, 2500, 1000, viscosity)
            expected = sphere.speed(found["time_s"])
            error = float(np.abs(-found["sphere_vz_m_s"] - expected).max() / sphere.terminal_speed())
            verification.record(f"settling_sphere {variant}, LAMMPS",
                                "largest error of v(t) over terminal speed", error, 0, 0.01, self.wall_s)
            self.assertLess(error, 0.01)

    def test_settling_two_way(self) -> None:
        found = self.run_case("lammps", "--variant", "lammps")
        budgets = self.summary["budgets"]
        self.assertLessEqual(budgets["momentum_defect"], 1e-10)
        self.assertLessEqual(budgets["solid_volume_defect"], 1e-12)
        expected = self.run_case("liggghts", "--variant", "two_way")
        self.same("settling_sphere two_way", found, expected,
                  ("sphere_vz_m_s", "sphere_z_m", "given_z_kg_m_s", "received_z_kg_m_s"))

    def test_bed_on_the_floor(self) -> None:
        for file, text in (("system/blockMeshDict", BLOCKS), ("0/U", VELOCITY), ("0/p", PRESSURE)):
            (self.case / "fluid" / file).write_text(text)
        for script in ("dem/in.setup", "dem/in.lammps"):
            self.change(script, BOX, "region box block 0 0.02 0 0.02 0 0.04 units box")
            self.change(script, ONE, BED)
            self.change(script, "variable start_height index 0.065\n", "")
        self.change("dem/in.setup", "gamman peratomtypepair 1 0", "gamman peratomtypepair 1 100")
        self.change("dem/in.lammps", "} 0 0 0.5 1\npair", "} 100 0 0.5 1\npair")
        self.change("dem/in.lammps", "} 0 0 0.5 1 zplane", "} 100 0 0.5 1 zplane")
        toml = (self.case / "case.toml").read_text()
        (self.case / "case.toml").write_text(
            "\n".join(line for line in toml.splitlines() if "start_height" not in line))
        # The highest sphere of one column is observed.
        words = ["--variant=two_way", "--set=case.end_time=0.05", "--set=observe.sphere.id=145",
                 "--set=coupling.regime=mild", "--force"]
        expected = self.run_case("liggghts", *words)
        found = self.run_case("lammps", *words, *LAMMPS)
        self.assertEqual(self.summary["particles"], 180)
        self.assertLessEqual(self.summary["budgets"]["momentum_defect"], 1e-10)
        moved = np.abs(found["sphere_z_m"] - found["sphere_z_m"][0]).max()
        self.assertLess(moved, 0.05 * 2e-3, "the bed does not hold")
        self.assertGreater(found["received_z_kg_m_s"][1:].min(), 0, "rising water pushes down")
        self.same("bed on the floor", found, expected,
                  ("sphere_z_m", "given_z_kg_m_s", "received_z_kg_m_s"))

    def test_vajont_slide(self) -> None:
        """The Vajont slide without water, coarse, on LAMMPS' half-spaces and on LIGGGHTS' triangles: mean speed and
        front to 12 s, 5 %: a ridge's edge lets grains sink a little, and the motion is chaotic."""
        words = ["--variant=lammps", "--set=fluid.engine=none", "--set=case.end_time=12", "--set=parameters.d_min=7.2",
                 "--set=parameters.d_max=15.2", "--set=parameters.coarse_grain=4", "--set=parameters.dem_dt=4e-3",
                 "--ranks-dem=2"]
        self.case = ROOT / "cases/vajont_east"
        found = self.run_case("half_spaces", *words)
        expected = self.run_case("triangles", *words, "--set=dem.engine=liggghts", "--set=dem.script=dem/in.setup")
        self.assertGreater(expected["slide_speed_m_s"].max(), 20, "it does not slide")
        for name in ("slide_speed_m_s", "slide_front_x_m"):
            error = float(np.abs(found[name] / expected[name].max() - expected[name] / expected[name].max()).max())
            verification.record("vajont_east without water, LAMMPS", f"{name} against LIGGGHTS, over its largest", error, 0,
                                0.05, self.wall_s)
            self.assertLess(error, 0.05, name)


if __name__ == "__main__":
    unittest.main()
