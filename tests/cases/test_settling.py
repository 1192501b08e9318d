"""settling_sphere with both real engines against an ODE integrated apart (settling_ode.py).

One-way: v(t) within 1 % of the terminal speed at every window, at Re 0.1, 1, 100 and with a particle
step of ten response times. Two-way: the excess over that within 30 % of the self-disturbance that
unsteady Stokes flow predicts, and the momentum budget closed."""

import os
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from launch import case as cases
from launch import cli, results, verification
from launch.places import ROOT
from tests.cases.settling_ode import Sphere


def sphere_of(case: cases.Case) -> Sphere:
    names = ("diameter", "solid_density", "fluid_density", "fluid_viscosity")
    return Sphere(*(case.parameters[n] for n in names))


class Settling(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.out = Path(holder.name).resolve() / "run"

    def run_variant(self, variant: str, *more: str) -> tuple[Sphere, dict[str, np.ndarray], dict]:
        start = time.monotonic()
        status = cli.main(["run", str(ROOT / "cases/settling_sphere"), "--variant", variant,
                           "--out", str(self.out), *more])
        summary = results.read_summary(self.out)
        self.wall_s = time.monotonic() - start
        self.assertEqual(status, 0, summary.get("reason"))
        self.assertEqual(summary["status"], "completed")
        return (sphere_of(cases.load("settling_sphere", variant)), results.read_history(self.out),
                summary)

    def follows_the_ode(self, variant: str, *more: str) -> None:
        sphere, history, _ = self.run_variant(variant, *more)
        expected = sphere.speed(history["time_s"])
        error = np.abs(-history["sphere_vz_m_s"] - expected) / sphere.terminal_speed()
        self.assertGreater(len(error), 15)
        verification.record(f"settling_sphere {' '.join((variant, *more))}",
                            "largest error of v(t) over terminal speed", float(error.max()), 0, 0.01,
                            self.wall_s)
        self.assertLess(error.max(), 0.01, f"at {history['time_s'][error.argmax()]:g} s")
        self.assertLess(np.abs(history["sphere_vx_m_s"]).max(), 1e-9 * sphere.terminal_speed())
        before, window = -history["sphere_vz_m_s"][1:-1], np.diff(history["time_s"])[1:]  # of its begin
        drag = [sphere.drag(v) / v for v in before]
        np.testing.assert_allclose(history["max_drag_response"][2:], drag * window / sphere.mass, rtol=1e-6)

    def test_one_way_re_0p1(self) -> None:
        self.follows_the_ode("one_way")

    def test_one_way_re_1(self) -> None:
        self.follows_the_ode("re_1")

    def test_one_way_re_100(self) -> None:
        self.follows_the_ode("re_100")

    def test_step_of_ten_response_times(self) -> None:
        self.follows_the_ode("stiff")

    def test_one_way_on_more_ranks(self) -> None:
        self.follows_the_ode("one_way", "--ranks-fluid", "2", "--ranks-dem", "2")

    def test_two_way(self) -> None:
        sphere, history, summary = self.run_variant("two_way")
        undisturbed = sphere.terminal_speed()
        excess = -history["sphere_vz_m_s"][-1] / undisturbed - 1
        expected = sphere.self_disturbance(history["time_s"][-1], summary["smoothing_length_m"])
        verification.record("settling_sphere two_way", "self-disturbance", excess, expected, 0.3,
                            self.wall_s)
        self.assertLess(abs(excess - expected), 0.3 * expected, f"excess {excess:.4f}, {expected:.4f}")
        budgets = summary["budgets"]
        self.assertLessEqual(budgets["momentum_defect"], 1e-10)
        self.assertLessEqual(budgets["momentum_outstanding"], 1e-2)
        self.assertLessEqual(budgets["solid_volume_defect"], 1e-12)
        self.assertEqual(budgets["particles_lost"], 0)
        window = history["time_s"][1] - history["time_s"][0]
        fastest = np.abs(history["sphere_vz_m_s"][:-1]).max()
        self.assertAlmostEqual(summary["extremes"]["max_kernels_crossed"],
                               fastest * window / summary["smoothing_length_m"], delta=1e-6 * fastest)

    def test_plain_mpirun_line(self) -> None:
        script = ROOT / "cases/settling_sphere/run.sh"
        status = cli.main(["run", "settling_sphere", "--variant", "stiff", "--out", str(self.out),
                           "--dry-run"])
        self.assertEqual(status, 0)
        done = subprocess.run([str(script), str(self.out)], env=dict(os.environ, PYTHONPATH=""),
                              timeout=100, check=False)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(len(results.read_history(self.out)["time_s"]), 21)


if __name__ == "__main__":
    unittest.main()
