"""What goes wrong ends the program within seconds, with the reason on the terminal."""
import os
import subprocess
import time
import unittest

import numpy as np

import kit


class Failures(unittest.TestCase):
    def expect(self, case, words, ranks=1):
        case.controls(end=0.1)
        case.case(0.1, 0.05, smoothing=1.5)
        start = time.monotonic()
        done = case.drive(ranks=ranks, fails=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn(words, done.stderr)
        self.assertLess(time.monotonic() - start, 20)
        case.done()

    def lake(self, **settings):
        return kit.column((8, 8), (8, 8), 4.0, dt=0.01, **settings)

    def test_turbulence_model(self):
        case = self.lake()
        case.write("constant/turbulenceProperties", "simulationType RAS; RAS { RASModel kEpsilon; }")
        self.expect(case, "only simulationType laminar")

    def test_missing_scheme(self):
        case = self.lake()
        case.write("system/fvSchemes", "ddtSchemes { default Euler; }")
        self.expect(case, "divSchemes", ranks=2)

    def test_sources_are_not_silently_dropped(self):
        case = self.lake()
        case.write("system/fvOptions", "pump { type vectorSemiImplicitSource; }")
        self.expect(case, "fvOptions is not supported")

    def test_not_a_number(self):
        case = self.lake()
        case.particles(case.centres()[5:9], 0.1, drag=1e200, v=(1e200, 0, 0))
        self.expect(case, "floating-point exception")

    def test_no_mesh(self):
        case = kit.Case((8, 1, 8), (8, 1, 8))
        self.expect(case, "Cannot find file")

    def alone(self, case, status, words):
        """The real program, without particles: reason on the terminal and in failure.txt."""
        case.controls(end=0.1)
        case.case(0.1, 0.05, dem="none", more="[physics]\ngravity = [0, 0, -9.81]")
        done = subprocess.run([os.environ["SLIDEWAVE_FOAM"], str(case.directory)], capture_output=True,
                              text=True, env=kit.ENVIRONMENT, timeout=30)
        self.assertEqual(done.returncode, status, done.stderr)
        self.assertIn(words, done.stderr)
        self.assertIn(words, (case.directory / "failure.txt").read_text())
        case.done()

    def test_program_refuses_what_it_cannot_open(self):
        case = self.lake()
        case.write("constant/turbulenceProperties", "simulationType LES;")
        self.alone(case, 2, "only simulationType laminar")

    def test_program_names_an_error_of_a_step(self):
        case = self.lake()
        schemes = case.fluid / "system/fvSchemes"
        schemes.write_text(schemes.read_text().replace("div(phirb,alpha)", "div(other)"))
        self.alone(case, 1, "div(phirb,alpha)")


if __name__ == "__main__":
    unittest.main()
