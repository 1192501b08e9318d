"""What goes wrong ends the program within seconds, with the reason on the terminal."""
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


if __name__ == "__main__":
    unittest.main()
