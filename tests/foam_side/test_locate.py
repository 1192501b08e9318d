"""Location against arithmetic on a sheared box: from nothing, from the last cell, outside, across ranks."""
import unittest

import numpy as np

import kit

NX, NZ, SLOPE = 12, 10, 0.3


class Locate(unittest.TestCase):
    def test_cells_of_moving_points(self):
        case = kit.Case((NX, 1, NZ), (12, 1, 10), slope=SLOPE).mesh()
        case.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);", "uniformDimensionedVectorField")
        number = np.arange(NX * NZ) / (NX * NZ)  # each cell has a saturation of its own
        case.fields(number)
        random = np.random.default_rng(3)
        n = 400
        start = np.stack([random.uniform(0, 12, n), random.uniform(-5, 5, n), random.uniform(0, 10, n)], axis=1)
        start[:, 2] += SLOPE * start[:, 0]
        velocity = (random.uniform(0, 12, n) - start[:, 0]) / 0.02
        case.particles(start, 0.0, v=np.stack([velocity, 0 * velocity, SLOPE * velocity], axis=1))
        case.controls(end=0.02)
        case.dt = 0.005
        case.case(0.02, 0.01, reaction="one_way")
        for ranks in (1, 2):
            samples, windows = case.drive(ranks=ranks)
            for window in (0, 1):  # the field of window 0 is the one written above; later it is the flow's
                rows = samples["window"] == window
                x, z = samples["x"][rows], samples["z"][rows]
                cell = np.floor(x).astype(int) + NX * np.floor(z - SLOPE * x).astype(int)
                found = np.rint(samples["saturation"][rows] * NX * NZ).astype(int)
                np.testing.assert_array_equal(found, cell)
            self.assertEqual(windows["farthest"][:2].max(), 0)
        case.done()

    def test_distance_outside(self):
        case = kit.Case((NX, 1, NZ), (12, 1, 10)).mesh()
        case.fields(np.zeros(NX * NZ))
        case.particles([[6.5, 0.5, 10.7], [-0.3, 0.5, 5.0]], 0.0)
        case.controls(end=1e-3)
        case.case(1e-3, 1e-3, reaction="one_way")
        _, windows = case.drive()
        self.assertAlmostEqual(windows["farthest"][0], 0.7, delta=1e-9)
        case.done()


if __name__ == "__main__":
    unittest.main()
