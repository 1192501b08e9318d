"""A sphere in a prescribed flow (slidewave_uniform) against an ODE integrated apart.

At rest the sphere settles as the ODE of settling_ode.py; in an oscillating shear flow it follows
m dv/dt = m g + rho V (Du/Dt - g) + drag(u - v), with u and Du/Dt written out here."""

import time
import unittest

import numpy as np
from scipy.integrate import solve_ivp

from launch import results, verification
from tests.cases.settling_ode import Sphere
from tests.launch.scratch import ScratchCase

SPHERE = Sphere(2e-3, 2500, 1000, 0.25)
START = np.array([0.001, 0.001, 0.065])
GRADIENT = np.array([[0, 0, 30.0], [0, 0, 0], [0, 0, 0]])  # shear: du/dz [1/s]
# Flow of some cm/s where the sphere is, so that each part of Du/Dt is percents of its speed.
U = np.array([0.01, 0.002, 0.008]) - GRADIENT @ START
A, PERIOD_S = np.array([0.004, 0.0, 0.003]), 0.02


class UniformFlow(ScratchCase):
    def run_uniform(self, *more: str) -> dict[str, np.ndarray]:
        self.out, start = self.place / "run", time.monotonic()
        self.status, text, err = self.slidewave("run", self.case, "--variant", "uniform", "--out",
                                                self.out, *more)
        self.wall_s = time.monotonic() - start
        self.assertEqual(results.read_summary(self.out).get("status"), "completed", text + err)
        return results.read_history(self.out)

    def follows(self, name: str, found: np.ndarray, expected: np.ndarray) -> None:
        error = float(np.abs(found - expected).max() / SPHERE.terminal_speed())
        verification.record(f"settling_sphere uniform {name}",
                            "largest error of v(t) over terminal speed", error, 0, 0.01, self.wall_s)
        self.assertLess(error, 0.01)

    def test_settling(self) -> None:
        history = self.run_uniform()
        self.assertEqual(self.status, 0, "misses the terminal velocity of the case")
        self.follows("at rest", -history["sphere_vz_m_s"], SPHERE.speed(history["time_s"]))
        self.assertEqual(len(history["time_s"]), 301)
        self.assertFalse((self.out / "fluid").exists(), "a fluid case was prepared for nothing")

    def test_oscillating_shear(self) -> None:
        settings = {"velocity": U, "amplitude": A, "gradient_u": GRADIENT[0]}
        words = [f"--set=uniform_flow.{k}={v.tolist()}" for k, v in settings.items()]
        history = self.run_uniform(*words, f"--set=uniform_flow.period={PERIOD_S}", "--ranks-fluid=2")
        times = history["time_s"]
        omega = 2 * np.pi / PERIOD_S
        expected_flow = U[:, None] + A[:, None] * np.sin(omega * times)
        for axis, row in zip("xyz", expected_flow):
            np.testing.assert_allclose(history[f"flow_v{axis}_m_s"], row, atol=1e-12)
        self.follows("oscillating", np.array([history[f"sphere_v{a}_m_s"] for a in "xyz"]),
                     self.velocities(times, omega))

    def test_alpha_by_type(self) -> None:
        """Two spheres of two types, apart, each as in a run of its own with its type's alpha; 1e-12: the same
        operations. A list that is not the script's types is refused."""
        alone = [self.run_uniform(f"--set=parameters.coarse_grain={alpha}", "--overwrite")["sphere_vz_m_s"]
                 for alpha in (1, 2)]
        self.assertGreater(abs(alone[0][-1] / alone[1][-1]), 2, "alpha makes no difference here")
        for name in ("kn", "kt"):
            self.change("dem/in.setup", f"{name} peratomtypepair 1 ", f"{name} peratomtypepair 2" + " ${contact_stiffness}" * 3 + " ")
        for name, value in (("gamman", 0), ("gammat", 0), ("coefficientFriction", 0.5)):
            self.change("dem/in.setup", f"{name} peratomtypepair 1", f"{name} peratomtypepair 2" + f" {value}" * 3)
        self.change("dem/in.setup", "create_box      1", "create_box      2")
        self.change("dem/in.setup", "set             group", "create_atoms    2 single 0.01 0.01 ${start_height} units box\n"
                    "set             group")
        self.change("case.toml", "[observe.sphere]", '[observe.second]\ntype = "particle"\nid = 2\n\n[observe.sphere]')
        both = self.run_uniform("--set=models.coarse_grain_by_type=[1, 2]", "--overwrite")
        for name, expected in zip(("sphere", "second"), alone):
            np.testing.assert_allclose(both[f"{name}_vz_m_s"], expected, rtol=1e-12, atol=0)
        status, _, _ = self.slidewave("run", self.case, "--variant", "uniform", "--out", self.place / "run", "--overwrite",
                                        "--set=models.coarse_grain_by_type=[1, 2, 3]")
        self.assertEqual(status, 2)
        self.assertIn("the particle script has 2 types", (self.place / "run/failure.txt").read_text())

    def velocities(self, times: np.ndarray, omega: float) -> np.ndarray:
        gravity = np.array([0, 0, -SPHERE.gravity])

        def rate(t: float, state: np.ndarray) -> np.ndarray:
            x, v = state[:3], state[3:]
            flow = U + A * np.sin(omega * t) + GRADIENT @ x
            acceleration = A * omega * np.cos(omega * t) + GRADIENT @ flow
            slip = flow - v
            speed = np.linalg.norm(slip)
            force = SPHERE.mass * gravity + SPHERE.fluid_density * SPHERE.volume * (acceleration - gravity)
            return np.concatenate([v, (force + SPHERE.drag(speed) * slip / speed) / SPHERE.mass])

        done = solve_ivp(rate, (0, times[-1]), np.concatenate([START, np.zeros(3)]), t_eval=times,
                         rtol=1e-9, atol=1e-13)
        return done.y[3:]


if __name__ == "__main__":
    unittest.main()
