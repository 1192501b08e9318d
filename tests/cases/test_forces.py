"""Forces beside drag on a sphere in a prescribed flow (slidewave_uniform), one at a time, against closed
forms and an ODE written down here: a fluid that speeds up (PHYSICS.md 3.2, F5), lift and torque in a
shear, and what an engine without their columns says."""

import time
import unittest

import numpy as np
from scipy.integrate import solve_ivp

from launch import results, verification
from launch.places import program
from tests.launch.scratch import ScratchCase

DIAMETER, FLUID_DENSITY, VISCOSITY = 2e-3, 1000.0, 0.25
VOLUME = np.pi / 6 * DIAMETER**3
START_Z, SHEAR = 0.065, 30.0


class Forces(ScratchCase):
    def setUp(self) -> None:
        super().setUp()
        # no weight: "vector 0 0 0" has no direction
        self.change("dem/in.setup", "${gravity_x} ${gravity_y} ${gravity_z}", "0 0 -1")

    def run_flow(self, density: float, **settings: object) -> dict[str, np.ndarray]:
        words = {"physics.gravity": "[0, 0, 0]", "models.drag": "none", "parameters.solid_density": density,
                 "parameters.dem_dt": 5e-5} | {k.replace("__", "."): v for k, v in settings.items()}
        out, start = self.place / f"run{time.monotonic_ns()}", time.monotonic()
        _, text, err = self.slidewave("run", self.case, "--variant", "uniform", "--out", out, "--force",
                                      *(f"--set={k}={v}" for k, v in words.items()))
        self.wall_s = time.monotonic() - start
        self.assertEqual(results.read_summary(out).get("status"), "completed", text + err)
        return results.read_history(out)

    def near(self, case: str, quantity: str, found: np.ndarray, expected: np.ndarray, tolerance: float) -> None:
        scale = np.abs(expected).max()
        error = float(np.abs(found - expected).max() / scale)
        verification.record(case, quantity, error, 0, tolerance, self.wall_s)
        self.assertLess(error, tolerance, f"{case}: {quantity}")

    def test_fluid_that_speeds_up(self) -> None:
        """dv/dt = a rho_f/rho_s by the pressure gradient alone, (1 + C) a/(rho_s/rho_f + C) with virtual
        mass; 1e-6: the sine that stands for a straight line bends by 4e-9, and no drag is there to err."""
        acceleration, amplitude = 3.0, 1000.0
        flow = {"uniform_flow__amplitude": f"[0, 0, {amplitude}]",
                "uniform_flow__period": 2 * np.pi * amplitude / acceleration}
        for ratio in (0.5, 1.0, 2.65):
            for law, c in (("none", 0.0), ("constant", 0.5)):
                history = self.run_flow(ratio * FLUID_DENSITY, models__virtual_mass=law, **flow)
                expected = acceleration * (1 + c) / (ratio + c) * history["time_s"]
                self.near(f"accelerated fluid, rho_s/rho_f {ratio:g}, virtual mass {law}",
                          "largest error of v(t)", history["sphere_vz_m_s"], expected, 1e-6)

    def test_lift_in_a_shear(self) -> None:
        """1 %: lift is that of the window's begin (here 0.5 % of its rate of change a window)."""
        density, u0 = 2500.0, 0.01
        history = self.run_flow(density, models__lift="saffman_mei", models__pressure_gradient="false",
                                uniform_flow__gradient_u=f"[0, 0, {SHEAR}]",
                                uniform_flow__velocity=f"[{u0 - SHEAR * START_Z}, 0, 0]")
        nu = VISCOSITY / FLUID_DENSITY
        scale = 1.615 * DIAMETER**2 * FLUID_DENSITY * np.sqrt(nu * SHEAR) / (density * VOLUME)

        def rate(_: float, state: np.ndarray) -> np.ndarray:
            z, vx, vz = state
            slip = np.array([u0 + SHEAR * (z - START_Z) - vx, -vz])
            s = np.sqrt(nu * SHEAR) / np.linalg.norm(slip)
            mei = 0.3 * (1 + np.tanh(2.5 * (np.log10(s) + 0.191))) * (0.667 + np.tanh(6 * (s - 0.32)))
            across = np.array([-slip[1], slip[0]])  # slip x vorticity / |vorticity|, in x and z
            return np.concatenate([[vz], scale * mei * across])

        times = history["time_s"]
        done = solve_ivp(rate, (0, times[-1]), [START_Z, 0, 0], t_eval=times, rtol=1e-10, atol=1e-14)
        for axis, expected in zip("xz", done.y[1:]):
            self.near("lift in a shear", f"largest error of v{axis}(t)", history[f"sphere_v{axis}_m_s"],
                      expected, 0.01)
        self.assertGreater(done.y[2][-1], 0.2 * u0, "lift does not act here")

    def test_torque_in_a_shear(self) -> None:
        """w = (curl u)/2 (1 - exp(-K t/I)), read from the energy; 1e-9: the kick is exact."""
        density = 2500.0
        history = self.run_flow(density, models__torque="rotational_drag", models__pressure_gradient="false",
                                uniform_flow__gradient_u=f"[0, 0, {SHEAR}]",
                                uniform_flow__velocity=f"[{-SHEAR * START_Z}, 0, 0]",
                                observe__slide__type="slide", case__end_time=3e-3, output__interval=3e-3)
        inertia = density * VOLUME * DIAMETER**2 / 10
        spin = np.sqrt(2 * history["kinetic_energy_J"] / inertia)
        rate = np.pi * VISCOSITY * DIAMETER**3 / inertia
        self.near("torque in a shear", "largest error of w(t)", spin,
                  SHEAR / 2 * (1 - np.exp(-rate * history["time_s"])), 1e-9)

    @unittest.skipUnless(program("slidewave_lammps").exists(), "LAMMPS is not built")
    def test_engine_without_the_columns(self) -> None:
        """LAMMPS takes neither added mass nor torque, and says so before anything runs."""
        for model, value, column in (("virtual_mass", "constant", "added_mass"),
                                     ("torque", "rotational_drag", "rotational_drag")):
            status, text, err = self.slidewave("run", self.case, "--variant", "uniform", "--out",
                                               self.place / model, f"--set=models.{model}={value}",
                                               "--set=dem.engine=lammps", "--set=dem.script=dem/in.lammps")
            self.assertEqual(status, 2, text + err)
            self.assertIn(f"models.{model}", text + err)
            self.assertIn(column, text + err)


if __name__ == "__main__":
    unittest.main()
