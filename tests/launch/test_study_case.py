"""A study of four points with both real engines: the speed of a falling sphere at Re 100 against the
equation of motion integrated apart. The window's error must be of first order, as one-way coupling
that keeps K of the window's start is."""

import contextlib
import csv
import io
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from launch import case as cases
from launch import cli
from tests.cases.settling_ode import Sphere

END = 0.125


class RealStudy(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name).resolve()

    def write_ode(self) -> Path:
        parameters = cases.load("settling_sphere", "re_100").parameters
        sphere = Sphere(*(parameters[n] for n in ("diameter", "solid_density", "fluid_density",
                                                  "fluid_viscosity")))
        times = np.linspace(0, END, 501)
        path = self.place / "ode.csv"
        path.write_text("time_s,sphere_vz_m_s\n" + "".join(
            f"{t:.9g},{-v:.9g}\n" for t, v in zip(times, sphere.speed(times))))
        return path

    def study(self, ode: Path) -> tuple[int, str]:
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            status = cli.main(["study", "settling_sphere", "--variant", "re_100", "--set",
                               f"case.end_time={END}", "--set", f"output.interval={END}", "--vary",
                               "coupling.window=0.0125,0.00625,0.003125,0.0015625", "--quantity",
                               "curve:sphere_vz_m_s", "--reference", str(ode), "--ranks-fluid", "1",
                               "--ranks-dem", "1", "--out", str(self.place / "study")])
        return status, out.getvalue()

    def test_four_windows(self) -> None:
        ode = self.write_ode()
        status, text = self.study(ode)
        self.assertEqual(status, 0, text)
        with (self.place / "study/study.csv").open(newline="") as stream:
            rows = list(csv.DictReader(stream))
        errors = [float(row["error"]) for row in rows]
        self.assertEqual([row["windows"] for row in rows], ["10", "20", "40", "80"])
        self.assertEqual(errors, sorted(errors, reverse=True))
        self.assertLess(errors[0], 0.05)
        for coarse, fine in zip(errors, errors[1:]):
            self.assertTrue(1.7 < coarse / fine < 2.8, errors)
        self.assertTrue(all(float(row["wall_s"]) > 0 and float(row["core_s"]) > 0 for row in rows))
        self.assertRegex(text, r"coupling\.window: order (0\.9|1\.[0-3])")
        self.assertRegex(text, r"for an error of 2 % use window=0\.00\d+, it takes [\d.]+ s")
        self.assertIn("window=0.0015625", (self.place / "study/study.svg").read_text())
        start = time.monotonic()
        status, text = self.study(ode)
        self.assertEqual(status, 0)
        self.assertIn("4 of 4 runs are complete already", text)
        self.assertLess(time.monotonic() - start, 10)


if __name__ == "__main__":
    unittest.main()
