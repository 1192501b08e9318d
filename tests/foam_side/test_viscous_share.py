"""Particles that carry V div(tau) leave eps div(tau) to the fluid: a shear wave u = sin kz then decays at
nu k^2 whatever the void fraction, here 0.6 in half of the layers and 1 in the others."""
import unittest

import kit
import numpy as np

N, DT, STEPS, NU, RHO = 24, 1e-3, 4, 1.0, 1000.0


class ViscousShare(unittest.TestCase):
    def decays(self, two_fluids):
        case = kit.Case((2, 1, N), (2 / N, 1 / N, 1), two_fluids=two_fluids, periodic=("x", "z"), dt=DT).mesh()
        fluid = f"transportModel Newtonian; nu {NU}; rho {RHO};"
        case.write("constant/transportProperties",
                   f"phases (water air); water {{ {fluid} }} air {{ {fluid} }} sigma 0;" if two_fluids else fluid)
        solution = case.fluid / "system/fvSolution"  # PISO alone would only sweep over the stress
        solution.write_text(solution.read_text().replace("momentumPredictor no", "momentumPredictor yes"))
        x, k = case.centres(), 2 * np.pi
        wave = np.sin(k * x[:, 2])
        case.fields(1.0, U=wave[:, None] * [1, 0, 0])
        case.controls(end=STEPS * DT)
        case.case(STEPS * DT, DT, more="[models]\nviscous_force = true")
        case.particles(x, np.where(x[:, 2] < 0.5, 0.4, 0) * case.cell_volume())
        samples, _ = case.drive()
        last = samples["window"] == samples["window"].max()
        curvature = (2 - 2 * np.cos(k / N)) * N**2  # k^2 of second differences
        expected = wave / (1 + NU * curvature * DT) ** STEPS
        for field, reference in (("velocityx", expected), ("viscous_stressx", -RHO * NU * curvature * expected)):
            error = np.abs(samples[field][last] - reference).max() / np.abs(reference).max()
            print("two fluids" if two_fluids else "one fluid", field, error)
            self.assertLess(error, 1e-9)  # the solvers
        case.done()

    def test_one_fluid(self):
        self.decays(two_fluids=False)

    def test_two_fluids(self):
        self.decays(two_fluids=True)


if __name__ == "__main__":
    unittest.main()
