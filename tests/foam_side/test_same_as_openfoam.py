"""Without particles, and with a speck of dust, each step is interFoam's (pimpleFoam's)."""
import shutil
import unittest

import numpy as np

import kit

STEPS, DT = 200, 1e-3
END = STEPS * DT


def dam(**settings):
    """A column of water that falls: dam break in a 2-D box."""
    case = kit.Case((24, 1, 24), (0.6, 0.025, 0.6), dt=DT, **settings).mesh()
    x = case.centres()
    case.fields(((x[:, 0] < 0.15) & (x[:, 2] < 0.3)).astype(float), wall="type noSlip;")
    case.controls(end=END)
    return case


def reference(case, solver, names):
    case.tool(solver)
    fields = {name: case.read(f"{END:g}", name) for name in names}
    shutil.rmtree(case.fluid / f"{END:g}")
    return fields


def difference(case, fields):
    return max(np.abs(case.read(f"{END:g}", name) - value).max() / max(1, np.abs(value).max())
               for name, value in fields.items())


class SameAsInterFoam(unittest.TestCase):
    names = ("alpha.water", "U", "p_rgh")

    def compare(self, **settings):
        case = dam(**settings)
        fields = reference(case, "interFoam", self.names)
        self.assertGreater(np.abs(fields["U"]).max(), 0.5)
        case.case(END, 0.02, smoothing=0.05)
        case.drive()
        nothing = difference(case, fields)
        case.particles([0.3, 0.01, 0.1], 1e-12 * case.cell_volume(), drag=1e-12)
        case.drive()
        speck = difference(case, fields)
        print(settings, "no particles", nothing, "speck", speck)
        self.assertLess(nothing, 1e-9)
        self.assertLess(speck, 1e-8)
        case.done()

    def test_explicit_phase_equation(self):
        self.compare()

    def test_predictor_subcycles_and_outer_iterations(self):
        self.compare(water="nAlphaCorr 2; nAlphaSubCycles 2; cAlpha 1; icAlpha 0.25; MULESCorr yes; "
                           "nLimiterIter 5;", extra_solution="nOuterCorrectors 2;")


class SameAsPimpleFoam(unittest.TestCase):
    def test_driven_cavity(self):
        case = kit.Case((16, 1, 16), (1, 0.1, 1), two_fluids=False, closed=True, dt=5e-3,
                        extra_solution="momentumPredictor yes;").mesh()
        case.fields(wall="type noSlip;", patches={"U": {"top": "type fixedValue; value uniform (1 0 0);"}})
        end = STEPS * 5e-3
        case.controls(end=end)
        case.tool("pimpleFoam")
        fields = {name: case.read(f"{end:g}", name) for name in ("U", "p")}
        shutil.rmtree(case.fluid / f"{end:g}")
        case.case(end, 0.1, smoothing=0.1)
        case.drive()
        differences = [np.abs(case.read(f"{end:g}", name) - value).max() for name, value in fields.items()]
        print("pimpleFoam", differences)
        self.assertLess(max(differences), 1e-9)
        case.done()


if __name__ == "__main__":
    unittest.main()
