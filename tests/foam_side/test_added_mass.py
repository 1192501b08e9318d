"""Fluid that particles move along, in the standing vortex u = sin kx cos kz, w = -cos kx sin kz: its DU/Dt,
k/2 (sin 2kx, sin 2kz), is convective only. Particles fill 0.4 of every cell, without drag: the fluid has
(eps rho + m) DU/Dt = -eps (grad p - rho g)."""
import unittest

import kit
import numpy as np

DT, RHO, G, FILL = 1e-3, 1000.0, np.array([0, 0, -9.81]), 0.4


class AddedMass(unittest.TestCase):
    def vortex(self, n, two_fluids, ranks=1):
        """DU/Dt at the cells' centres and in closed form, on n by n cells."""
        case = kit.Case((n, 1, n), (1, 1 / n, 1), two_fluids=two_fluids, periodic=("z",), dt=DT).mesh()
        if not two_fluids:
            case.write("constant/transportProperties", "transportModel Newtonian; nu 1e-9; rho 1000;")
        x, k = case.centres(), 2 * np.pi
        u = np.stack([np.sin(k * x[:, 0]) * np.cos(k * x[:, 2]), 0 * x[:, 0],
                      -np.cos(k * x[:, 0]) * np.sin(k * x[:, 2])], axis=1)
        case.fields(1.0, U=u)
        case.controls(end=3 * DT)
        case.case(3 * DT, DT, more='[models]\nvirtual_mass = "constant"')
        case.particles(x, FILL * case.cell_volume())
        samples, windows = case.drive(ranks)
        last = samples["window"] == samples["window"].max()
        vector = lambda name: np.stack([samples[name + axis][last] for axis in "xyz"], axis=1)
        found = vector("acceleration")
        # 1e-3: what PISO leaves of a step of Courant number 0.05
        pressure = (1 - FILL) * (RHO * G - vector("pressure_gradient"))
        both = ((1 - FILL) * RHO + FILL * RHO / 2) * found
        rest = np.abs(both - pressure).max() / np.abs(both).max()
        print(n, "two fluids" if two_fluids else "one fluid", "balance", rest)
        self.assertLess(rest, 1e-3)
        # What particles take is what the fluid gives, to round-off of the sum without signs.
        taken = DT * RHO / 2 * FILL * case.cell_volume() * np.abs(found).sum()
        for axis in "xyz":
            lost = windows["given_" + axis][-1] - windows["particle_impulse_" + axis][-1]
            self.assertLess(abs(lost) / taken, 1e-12)
        case.done()
        expected = k / 2 * np.stack([np.sin(2 * k * x[:, 0]), 0 * x[:, 0], np.sin(2 * k * x[:, 2])], axis=1)
        return found, expected

    def converges(self, two_fluids):
        """DU/Dt goes to the closed form at second order, the convection scheme's."""
        errors = []
        for n in (24, 48):
            found, expected = self.vortex(n, two_fluids)
            errors.append(np.abs(found - expected).max() / np.abs(expected).max())
        coarse, fine = errors
        print("DU/Dt", coarse, fine)
        self.assertLess(coarse, 0.1)
        self.assertGreater(np.log2(coarse / fine), 1.8)

    def test_one_fluid(self):
        self.converges(two_fluids=False)

    def test_two_fluids(self):
        self.converges(two_fluids=True)

    def test_ranks(self):
        alone, both = self.vortex(24, True)[0], self.vortex(24, True, ranks=2)[0]
        print("ranks", np.abs(both - alone).max() / np.abs(alone).max())
        self.assertLess(np.abs(both - alone).max() / np.abs(alone).max(), 1e-9)  # the solvers' tolerance


if __name__ == "__main__":
    unittest.main()
