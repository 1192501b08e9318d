"""One rank and two give the same: kernel to round-off, flow to the solvers' tolerance."""
import unittest

import numpy as np

import kit


class Decomposition(unittest.TestCase):
    def test_one_and_two_ranks(self):
        case = kit.column((20, 16), (20, 16), 8.0, dt=0.02, tolerance=1e-14)
        x = case.centres()
        cloud = x[(np.abs(x[:, 0] - 10) < 5) & (np.abs(x[:, 2] - 8) < 3)]
        case.particles(cloud + [0.1, 0, 0.2], 0.4, v=(1, 0, -2), drag=500, force=(1, 0, 0))
        case.controls(end=0.2)
        case.case(0.2, 0.05, smoothing=2.5,
                  more='[observe.wave]\ntype = "wave"\nlevel = 8.0\nbank_x = 12.0\n'
                       '[observe.left]\ntype = "gauge"\nx = 0.5\n')
        one, windows_one = case.drive()
        two, windows_two = case.drive(ranks=2)
        worst = {name: np.abs(one[name] - two[name]).max() / (np.abs(one[name]).max() + 1e-300) for name in one}
        start = one["window"] == 0
        print(worst)
        for name in ("void_fraction", "density", "viscosity"):
            np.testing.assert_allclose(one[name][start], two[name][start], rtol=1e-12)
        for name in worst:
            self.assertLess(worst[name], 1e-7, name)
        for name in ("solid_volume", "wave_height_m", "left_level_m", "min_void_fraction", "water_volume_m3"):
            np.testing.assert_allclose(windows_one[name], windows_two[name], rtol=1e-8, err_msg=name)
        case.done()


if __name__ == "__main__":
    unittest.main()
