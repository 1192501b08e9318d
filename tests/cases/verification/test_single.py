"""One sphere: order of the coupling in time, and the flow it drives itself on coarse and fine meshes."""

import os
import unittest

import numpy as np

from tests.cases.settling_ode import Sphere
from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class Order(Verification):
    """Release from rest, Re 157 in the end. Drag is exact within a window but for its coefficient, which
    is that of the window's start: first order. The reference is the ODE integrated apart."""

    def test_order_in_time(self) -> None:
        sphere = Sphere(1e-3, 2650.0, 1000.0, 1e-3)
        final, end = sphere.terminal_speed(), 0.032
        windows, errors = [8e-4, 4e-4, 2e-4, 1e-4], []
        for window in windows:
            run = self.run_case("terminal", parameters__diameter=sphere.diameter, case__end_time=end,
                                parameters__solid_density=sphere.solid_density,
                                uniform_flow__density=sphere.fluid_density,
                                uniform_flow__viscosity=sphere.fluid_viscosity, parameters__room=0.1,
                                coupling__window=window, parameters__dem_dt=5e-5, output__interval=end,
                                check__speed=final, parameters__contact_stiffness=50)
            expected = sphere.speed(run.history["time_s"][1:])
            errors.append(np.abs(-run.history["one_vz_m_s"][1:] - expected).max() / final)
        order = np.polyfit(np.log(windows), np.log(errors), 1)[0]
        self.near("order in time, released sphere", "order", order, 1, 0.15, run, absolute=True)
        self.near("order in time, released sphere", "largest error at a window of 1e-4 s, over the final speed",
                  errors[-1], 0, 0.005, run)


class SelfDisturbance(Verification):
    """Excess of the terminal speed on cells of 1 to 10 diameters, within 30 % of unsteady Stokes flow
    through a Gaussian kernel in unbounded fluid; here are cells, walls, and a history of the force."""

    def settles(self, cells: float) -> None:
        sphere = Sphere(2e-3, 2500.0, 1000.0, 2.5)
        cell = cells * sphere.diameter
        length = 1.5 * max(cell, sphere.diameter)
        end = 4 * (length**2 / 2) / (sphere.fluid_viscosity / sphere.fluid_density)
        run = self.run_case("self_disturbance", parameters__cell=cell, parameters__half=10 * cell,
                            coupling__window=end / 40, case__end_time=end, output__interval=end,
                            parameters__dem_dt=end / 40 / np.ceil(end / 40 / 2e-4))
        excess = -run.history["one_vz_m_s"][-1] / sphere.terminal_speed() - 1
        self.near(f"self_disturbance, cells of {cells:g} diameters", "excess of the terminal speed", excess,
                  sphere.self_disturbance(end, length), 0.3, run)
        self.budgets_close(f"self_disturbance, cells of {cells:g} diameters", run)

    def test_cells_of_1(self) -> None:
        self.settles(1)

    def test_cells_of_10(self) -> None:
        self.settles(10)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for cells in (2, 3, 5):
            self.settles(cells)


if __name__ == "__main__":
    unittest.main()
