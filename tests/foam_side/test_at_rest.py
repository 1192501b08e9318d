"""A lake at rest stays at rest: open, on an oblique mesh, and with a bed of particles in it."""
import unittest

import numpy as np

import kit

G = 9.81
STEPS, DT = 100, 0.01
END = STEPS * DT


def water_speed(case):
    speed = np.linalg.norm(case.read(f"{END:g}", "U"), axis=1)
    water = case.read(f"{END:g}", "alpha.water")
    return (speed * water).sum() / water.sum(), speed.max()


class Rest(unittest.TestCase):
    def lake(self, depth, more="", **settings):
        case = kit.column((20, 20), (10, 10), depth, dt=DT, **settings)
        case.controls(end=END)
        case.case(END, 0.1, smoothing=1.0, more=more)
        return case

    def test_flat_mesh_surface_inside_a_cell(self):
        case = self.lake(5.2)
        case.drive()
        mean, largest = water_speed(case)
        print("flat", mean, largest)
        self.assertLess(largest, 1e-6)
        case.done()

    def test_oblique_mesh(self):
        """Two-point normal gradients: their corrections would see the jump of the density as a slope."""
        case = self.lake(6, slope=0.1, normals="uncorrected", extra_solution="nNonOrthogonalCorrectors 0;")
        case.write("constant/hRef", "dimensions [0 1 0 0 0 0 0]; value 6;", "uniformDimensionedScalarField")
        before = case.read("0", "alpha.water").sum()
        case.drive()
        mean, largest = water_speed(case)
        print("oblique", mean, largest)
        self.assertLess(mean, 0.05)
        self.assertAlmostEqual(case.read(f"{END:g}", "alpha.water").sum() / before, 1, delta=1e-10)
        case.done()

    def test_held_bed_under_the_surface_and_through_it(self):
        """Pressure at the base is rho g h, not eps rho g h; a particle under water is lifted by rho g V."""
        self.bed_rests(lambda samples: samples["pressure_gradientz"] / -G)

    def test_held_bed_in_formulation_b(self):
        """The same where Archimedes' force is buoyancy: its reaction is part of the fluid's rho g."""
        self.bed_rests(lambda samples: samples["density"], '[models]\nformulation = "B"')

    def bed_rests(self, lift_of, more=""):
        """lift_of: buoyancy over V g at the particles."""
        case = self.lake(5.2, more)
        x = case.centres()
        bed = x[(x[:, 2] < 7) & (x[:, 0] > 3)]
        case.particles(bed, 0.4 * case.cell_volume(), drag=1e4)
        samples, windows = case.drive()
        mean, largest = water_speed(case)
        print("bed", mean, largest)
        self.assertLess(largest, 1e-6)
        last = samples["window"] == samples["window"].max()
        lift = lift_of(samples)[last]
        # deep: farther from the surface than the kernel reaches
        np.testing.assert_allclose(lift[bed[:, 2] < 1.2], 1000, rtol=1e-6)
        column = np.abs(bed[:, 0] - bed[0, 0]) < 1e-9  # monotone from water to air
        by_height = lift[column][np.argsort(bed[column, 2])]
        self.assertGreater(column.sum(), 10)
        self.assertLess(np.diff(by_height).max(), 1e-6 * 1000)
        self.assertGreaterEqual(lift.min(), 0.99 * 1.2)
        self.assertLessEqual(lift.max(), 1.01 * 1000)
        np.testing.assert_allclose(lift[bed[:, 2] > 6.9], 1.2, rtol=0.5)
        eps = case.read(f"{END:g}", "eps")
        self.assertLess(eps.min(), 0.65)
        p = case.read(f"{END:g}", "p")
        base, above = np.argmin(x[:, 2]), np.argmin(np.abs(x[:, 2] - 4.25) + np.abs(x[:, 0] - x[0, 0]))
        self.assertAlmostEqual((p[base] - p[above]) / (1000 * G * 4), 1, delta=1e-6)
        for name in ("water_volume_defect", "air_volume_defect"):
            self.assertLess(windows[name].max(), 1e-9)
        case.done()


if __name__ == "__main__":
    unittest.main()
