"""ESyS-Particle, the paper's engine, as the particle side: one master and one worker, beside a prescribed flow and
beside OpenFOAM. The sphere follows the ODE; a heap of spheres sinks and lands as LIGGGHTS' does."""

import os
import re
import signal
import subprocess
import time
import unittest
from pathlib import Path

import numpy as np

from launch import places, ranks, results, verification
from tests.cases.settling_ode import Sphere
from tests.launch.scratch import ScratchCase

ESYS = ("--set=dem.engine=esys", "--set=dem.script=dem/sphere.py")
ONE_ESYS = "sim.createParticle(RotSphere(id=1, posn=Vec3(0.001, 0.001, given(\"v_start_height\", 0.065))"
ONE = "create_atoms    1 single 0.001 0.001 ${start_height} units box"
# 4 x 4 x 4 spheres, 2.4 mm apart, one row shifted so that they topple.
PLACES = [(-0.006 + 2.4e-3 * i + 3e-4 * k, -0.004 + 2.4e-3 * j - 2e-4 * (k % 2), 2e-3 + 2.4e-3 * k)
          for k in range(4) for j in range(4) for i in range(4)]
CONTACTS = """
sim.createInteractionGroup(RotFrictionPrms(name="contact", normalK=v_contact_stiffness, dynamicMu=0.5, staticMu=0.5,
                                           shearK=v_contact_stiffness, scaling=False))
sim.createWall(name="floor", posn=Vec3(0, 0, 0), normal=Vec3(0, 0, 1))
# ESyS multiplies a wall's stiffness by pi times the radius.
sim.createInteractionGroup(NRotElasticWallPrms(name="rest", wallName="floor",
                                               normalK=v_contact_stiffness / (pi * v_diameter / 2)))
"""


class Esys(ScratchCase):
    def run_case(self, name: str, *more: str) -> dict[str, np.ndarray]:
        self.out, start = self.place / name, time.monotonic()
        _, text, err = self.slidewave("run", self.case, "--out", self.out, *more)
        self.wall_s = time.monotonic() - start
        self.summary = results.read_summary(self.out)
        self.assertEqual(self.summary.get("status"), "completed", text + err)
        return results.read_history(self.out)

    def test_settling_against_the_ode(self) -> None:
        for variant, viscosity in (("uniform", 0.25), ("one_way", 0.25), ("stiff", 2.5)):
            found = self.run_case(variant, "--variant", variant, *ESYS)
            sphere = Sphere(2e-3, 2500, 1000, viscosity)
            expected = sphere.speed(found["time_s"])
            error = float(np.abs(-found["sphere_vz_m_s"] - expected).max() / sphere.terminal_speed())
            verification.record(f"settling_sphere {variant}, ESyS-Particle",
                                "largest error of v(t) over terminal speed", error, 0, 0.01, self.wall_s)
            self.assertLess(error, 0.01, variant)

    def test_settling_two_way(self) -> None:
        found = self.run_case("esys", "--variant", "esys")
        self.assertLessEqual(self.summary["budgets"]["momentum_defect"], 1e-10)
        expected = self.run_case("liggghts", "--variant", "two_way")
        error = float(np.abs(found["sphere_vz_m_s"] - expected["sphere_vz_m_s"]).max()
                      / np.abs(expected["sphere_vz_m_s"]).max())
        verification.record("settling_sphere two_way, ESyS-Particle", "v(t) against LIGGGHTS, relative", error, 0,
                            1e-3, self.wall_s)
        self.assertLess(error, 1e-3)

    def test_heap_under_water(self) -> None:
        self.change("dem/in.setup", ONE, "\n".join(
            f"create_atoms 1 single {x:.6g} {y:.6g} {z:.6g} units box" for x, y, z in PLACES))
        script = self.case / "dem/sphere.py"
        text = script.read_text().replace(
            ONE_ESYS, f"for number, (x, y, z) in enumerate({PLACES!r}, start=1):\n"
            "    sim.createParticle(RotSphere(id=number, posn=Vec3(x, y, z)")
        text = text.replace("import GravityPrms,", "import GravityPrms, NRotElasticWallPrms, RotFrictionPrms,")
        script.write_text(text + CONTACTS)
        for file in ("dem/in.setup", "dem/in.lammps", "dem/sphere.py"):  # one place fewer uses it
            path = self.case / file
            path.write_text(re.sub(r"variable start_height.*\n", "", path.read_text()))
        toml = (self.case / "case.toml").read_text().replace('type = "particle"\nid = 1', 'type = "slide"')
        toml = toml.replace("[observe.sphere]", "[observe.slide]").replace("sphere_vz_m_s", "slide_speed_m_s")
        (self.case / "case.toml").write_text("\n".join(x for x in toml.splitlines() if "start_height" not in x))
        words = ("--variant=two_way", "--set=case.end_time=0.13", "--set=parameters.dem_dt=5e-5", "--set=output.interval=0.13",
                 "--set=coupling.regime=mild", "--force")
        expected = self.run_case("liggghts", *words)
        found = self.run_case("esys", *words, *ESYS)
        self.assertEqual(self.summary["particles"], 64)
        self.assertLessEqual(self.summary["budgets"]["momentum_defect"], 1e-10)
        self.assertEqual(self.summary["budgets"]["particles_lost"], 0)
        early = found["time_s"] <= 0.06  # sinking; then they land, on a floor without friction in ESyS
        for what, part, tolerance in (("sinking", early, 0.002), ("landing", ~early, 0.1)):
            error = float(np.abs(found["slide_speed_m_s"] - expected["slide_speed_m_s"])[part].max()
                          / expected["slide_speed_m_s"].max())
            verification.record("heap under water, ESyS-Particle", f"mean speed against LIGGGHTS, {what}", error, 0,
                                tolerance, self.wall_s)
            self.assertLess(error, tolerance, what)
        self.assertGreater(found["max_overlap"].max(), 0, "nothing ever touched")

    def prepared(self) -> list[str]:
        """A prepared run directory beside a prescribed flow, and its mpirun line."""
        status, _, err = self.slidewave("run", self.case, "--variant", "uniform", *ESYS, "--dry-run", "--overwrite",
                                        "--out", self.place / "run")
        self.assertEqual(status, 0, err)
        return ranks.mpirun_words(self.place / "run", 1, 2, "uniform_flow", "esys")

    def test_failures_end_both_programs(self) -> None:
        for text, words in (("\nsim.noSuchThing()\n", ("sphere.py", "line ", "noSuchThing")),
                            ("\nsim.setNumTimeSteps(3)\nsim.run()\n", ("sim.run()", "remove it")),
                            ("\ndel sim\n", ("sim", "name the simulation"))):
            line = self.prepared()
            with (self.place / "run/dem/sphere.py").open("a") as script:
                script.write(text)
            done = subprocess.run(line, capture_output=True, text=True, timeout=20, check=False)
            self.assertEqual(done.returncode, 2, done.stderr)
            for word in words:
                self.assertIn(word, done.stderr)

    def test_killed_worker_takes_all_along(self) -> None:
        line = self.prepared()
        toml = self.place / "run/case.toml"
        toml.write_text(re.sub(r"(?m)^end_time = .*", "end_time = 300.0", toml.read_text()))
        child = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(child.kill)
        for _ in range(200):
            if (self.place / "run/history.csv").exists():
                break
            time.sleep(0.1)
        program = str(places.program("slidewave_esys"))
        ours = sorted(int(p.name) for p in Path("/proc").iterdir() if p.name.isdigit()
                      and _words(p)[:2] == [program, str(self.place / "run")])
        self.assertEqual(len(ours), 2)
        os.kill(ours[1], signal.SIGKILL)
        self.assertNotEqual(child.wait(timeout=10), 0)


def _words(process: Path) -> list[str]:
    try:
        return (process / "cmdline").read_text().split("\0")
    except OSError:
        return []


if __name__ == "__main__":
    unittest.main()
