"""Pores that move, drag, and what the budgets say."""
import unittest

import numpy as np

import kit


def box(cells, size, **settings):
    return kit.Case(cells, size, two_fluids=False, **settings).mesh()


class Drag(unittest.TestCase):
    def test_slip_decays_as_implicit_euler_in_a_uniform_bed(self):
        """U_n = U_0 / (1 + K dt/(eps rho))^n, and the budget is the momentum lost."""
        case = box((8, 1, 6), (8, 1, 6), periodic=("x", "z"), dt=0.01,
                   extra_solution="nCorrectors 14;")
        case.fields(U=(1, 0, 0.5))
        volume, drag, steps = 0.3, 2e4, 20
        case.particles(case.centres(), volume, drag=drag)
        case.controls(end=0.2)
        case.case(0.2, 0.1, smoothing=2.0)
        samples, windows = case.drive()
        eps = 0.7
        expected = (1 + drag * 0.01 / (eps * 1000)) ** -steps
        U = case.read("0.2", "U")
        np.testing.assert_allclose(U[:, 0], expected, rtol=1e-10)
        np.testing.assert_allclose(U[:, 2], 0.5 * expected, rtol=1e-10)
        given = windows["given_x"].sum()
        self.assertAlmostEqual(given / (eps * 1000 * 48 * (1 - expected)), 1, delta=1e-10)
        np.testing.assert_allclose(windows["given_x"], windows["particle_impulse_x"], rtol=1e-11)
        case.done()

    def test_momentum_of_a_periodic_box_with_a_cloud(self):
        """Fluid momentum changes by what is given plus the particles' share of the pressure."""
        case = box((16, 1, 16), (16, 1, 16), periodic=("x", "z"), dt=0.01,
                   extra_solution="nOuterCorrectors 12; nCorrectors 3;")
        case.fields(U=(1, 0, 0))
        x = case.centres()
        cloud = x[np.hypot(x[:, 0] - 8, x[:, 2] - 8) < 4]
        case.particles(cloud, 0.3, drag=3e3, force=(0, 0, 50))
        case.controls(end=0.2)
        case.case(0.2, 0.1, smoothing=2.0)
        samples, windows = case.drive()
        eps, U = case.read("0.2", "eps"), case.read("0.2", "U")
        change = 1000 * ((eps[:, None] * U).sum(axis=0) - eps.sum() * np.array([1, 0, 0]))
        pressure = np.array([(windows[f"cell_pressure_{a}"][1:] * 0.1).sum() for a in "xyz"])
        pressure[2] -= -9.81 * 1000 * windows["solid_volume"][0] * 0.2  # the flow's p has no hydrostatics
        given = np.array([windows[f"given_{a}"].sum() for a in "xyz"])
        print("momentum", change, pressure - given)
        np.testing.assert_allclose(change[[0, 2]], (pressure - given)[[0, 2]],
                                   atol=1e-4 * np.abs(change).max())
        for axis in "xz":
            scale = np.abs(windows[f"given_{axis}"]).max()
            self.assertLess(np.abs(windows[f"given_{axis}"] - windows[f"particle_impulse_{axis}"]).max(),
                            1e-10 * scale)
            scale = np.abs(windows["cell_pressure_x"]).max()
            self.assertLess(np.abs(windows[f"cell_pressure_{axis}"] - windows[f"particle_pressure_{axis}"]).max(),
                            1e-10 * scale)
        np.testing.assert_allclose(windows["particle_volume"], windows["solid_volume"], rtol=1e-12)
        case.done()


class Pores(unittest.TestCase):
    def test_plug_flow_into_a_step_of_the_void_fraction(self):
        """The flux stays uniform through the bed's surface: eps U is the inlet's everywhere."""
        case = box((40, 1, 8), (40, 1, 8), dt=0.1)
        case.fields(patches={"U": {"left": "type fixedValue; value uniform (1 0 0);", "top": "type slip;",
                                   "right": "type zeroGradient;"},
                             "p": {"top": "type zeroGradient;", "right": "type fixedValue; value uniform 0;"}},
                    U=(1, 0, 0))
        x = case.centres()
        case.particles(x[(x[:, 0] > 15) & (x[:, 0] < 30)], 0.5)
        case.controls(end=20)
        case.case(20, 1, smoothing=3.0)
        case.drive()
        flux = (case.read("20", "eps")[:, None] * case.read("20", "U"))
        print("plug flow", np.abs(flux[:, 0] - 1).max(), np.abs(flux[:, 2]).max())
        self.assertLess(np.abs(flux[:, 0] - 1).max(), 5e-2)
        self.assertLess(np.abs(flux[:, 2]).max(), 1e-3)
        case.done()

    def test_saturation_stays_one_while_a_cloud_moves_through_water(self):
        case = kit.Case((20, 1, 20), (20, 1, 20), dt=0.02, closed=True).mesh()
        case.fields(np.ones(400))
        x = case.centres()
        cloud = x[np.hypot(x[:, 0] - 6, x[:, 2] - 10) < 3]
        case.particles(cloud, 0.4, v=(4, 0, -1), drag=100)
        case.controls(end=1)
        case.case(1, 0.1, smoothing=2.0)
        samples, windows = case.drive()
        water = case.read("1", "alpha.water")
        print("saturation", water.min() - 1, water.max() - 1, np.abs(case.read("1", "U")).max())
        self.assertLess(np.abs(water - 1).max(), 1e-10)
        self.assertLess(windows["water_volume_defect"].max(), 1e-12)
        self.assertLess(windows["min_void_fraction"].min(), 0.75)
        case.done()

    def test_level_rises_by_the_volume_that_sinks_in(self):
        """A cloud enters the water from above: pores take the water's room, and nothing is lost."""
        case = kit.column((16, 16), (16, 16), 8.0, dt=0.02)
        case.controls("adjustTimeStep yes;", end=2)
        x = case.centres()
        cloud = x[(np.abs(x[:, 0] - 8) < 3) & (np.abs(x[:, 2] - 12) < 2)]
        case.particles(cloud, 0.4, v=(0, 0, -4), drag=500)
        case.case(2, 0.05, smoothing=1.5, more='[observe.left]\ntype = "gauge"\nx = 0.5\n')
        _, windows = case.drive()
        rise = windows["left_level_m"][-1] - 8
        print("rise", rise, "of", 0.4 * len(cloud) / 16, "defects", windows["water_volume_defect"].max(),
              windows["air_volume_defect"].max(), "Courant", windows["max_courant"].max())
        self.assertAlmostEqual(windows["left_level_m"][0], 8, delta=1e-12)
        self.assertGreater(rise, 0)
        self.assertLess(windows["water_volume_defect"].max(), 1e-10)
        self.assertLess(windows["air_volume_defect"].max(), 1e-6)
        case.done()


if __name__ == "__main__":
    unittest.main()
