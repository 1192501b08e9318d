"""Forces beside drag and the two formulations with both real engines, against closed forms."""

import math
import os
import unittest

import numpy as np

from tests.cases.verification import spheres
from tests.cases.verification.runs import Run, Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class VirtualMass(Verification):
    """Free particles slow down in a fluid that they take along: per volume
    eps rho u' = -B, phi rho_s v' = B, B = n (K (u - v) + C rho V (u' - v')): the slip falls at
    L n K/(1 + L C rho phi), L = 1/(eps rho) + 1/(phi rho_s)."""

    def slows_down(self, law: str, x: float, window: float, tolerance: float) -> None:
        phi, d, rho_s, rho, speed, time_s = 0.303, 1e-3, 2650.0, 1000.0, 0.01, 0.04
        eps = 1 - phi
        c = {"none": 0.0, "constant": 0.5, "zuber": 0.5 * (1 + 2 * phi) / (1 - phi)}[law]
        spacing = d * (math.pi / 6 / phi) ** (1 / 3)
        drag = x * rho_s * spheres.volume(d) / window
        run = self.run_case(
            "suspension", parameters__spacing=spacing, coupling__window=window, coupling__regime="mild",
            parameters__fluid_viscosity=spheres.stokes_viscosity(drag, eps, d), parameters__fluid_density=rho,
            coupling__smoothing_length=2.4 * spacing, models__virtual_mass=law,
            case__end_time=time_s, output__interval=time_s, force=True)
        both = 1 / (eps * rho) + 1 / (phi * rho_s)
        rate = both * phi / spheres.volume(d) * drag / (1 + both * c * rho * phi)
        mixture = phi * rho_s * speed / (phi * rho_s + eps * rho)
        v = mixture + (speed - mixture) * np.exp(-rate * run.history["time_s"])
        error = np.abs(run.history["one_vz_m_s"] - v).max() / (speed - mixture)
        case = f"suspension, virtual mass {law}, K W/m {x:g}"
        self.near(case, "largest error of v(t) over the fall", error, 0, tolerance, run)
        self.budgets_close(case, run)
        # Momentum of both, with what the ledger still owes to the fluid: none is lost.
        ledger = run.history["ledger_z_kg_m_s"][-1] / (64 * spacing**3)
        kept = phi * rho_s * run.history["one_vz_m_s"][-1] + eps * rho * run.field("U")[:, 2].mean() - ledger
        self.near(case, "momentum over the first", kept / (phi * rho_s * speed), 1, 1e-9, run)

    def test_suspension(self) -> None:
        """1 %: the window's lag, first order in K W/m (halving the window halves it: full)."""
        self.slows_down("constant", 0.01, 5e-4, 0.01)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for law in ("none", "constant", "zuber"):
            self.slows_down(law, 0.01, 5e-4, 0.01)
            self.slows_down(law, 0.005, 2.5e-4, 0.005)


class Formulations(Verification):
    """A uniform bed that is held, constant flow: -dp/dz and the whole force on the particles, f_A - V dp/dz
    in formulation A and f_B in B, are the same. 1e-6: the solvers' tolerance and that of the pressure."""

    def flows(self, reynolds: float, formulation: str) -> tuple[float, float, Run]:
        eps, size, mu, rho, layers, spacing = 0.4, 1e-3, 1e-3, 1000.0, 25, 1e-3
        diameter = spacing * (0.6 * 6 / math.pi) ** (1 / 3)
        run = self.run_case("fixed_bed", parameters__diameter=diameter, coupling__regime="mild",
                            parameters__inlet_velocity=reynolds * mu / (rho * size) / eps,
                            models__formulation=formulation, force=True)
        p = run.probe("p")[-1, 1:] * rho
        gradient = (p[0] - p[1]) / (10 * spacing)
        force = run.history["received_z_kg_m_s"][-1] / (run.history["time_s"][-1] - run.history["time_s"][-2])
        if formulation == "A":
            force += 9 * layers * spheres.volume(diameter) * gradient
        return gradient, force, run

    def same(self, reynolds: float) -> None:
        gradient_a, force_a, _ = self.flows(reynolds, "A")
        gradient_b, force_b, run = self.flows(reynolds, "B")
        case = f"fixed_bed, B against A, Re {reynolds:g}"
        self.near(case, "pressure drop [Pa/m]", gradient_b, gradient_a, 1e-6, run)
        self.near(case, "whole force on the particles [N]", force_b, force_a, 1e-6, run)
        self.near(case, "force that the pressure drop carries [N]", force_b, gradient_b * 9e-6 * 25e-3, 1e-6, run)

    def test_same_bed(self) -> None:
        self.same(1.0)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for reynolds in (0.1, 10.0, 100.0):
            self.same(reynolds)


class Channel(Verification):
    """Plane Poiseuille flow, -dp/dx = G: div(tau) = -G everywhere, curl u/2 = G (z - h/2)/(2 mu) across.
    1e-6 of the stress: fluid that has not quite developed; 1e-3 of the spin: the scheme at the walls."""

    def drifts(self, *words: str) -> None:
        g, mu, h, rho_s, d, z = 2000.0, 1.0, 0.01, 1000.0, 5e-4, 0.00225
        run = self.run_case("channel", *words)
        start = int(np.argmax(run.history["time_s"] > 0.0055))
        t = run.history["time_s"][start:] - run.history["time_s"][start]
        v = run.history["one_vx_m_s"][start:]
        slope = (v[-1] - v[0]) / t[-1]
        self.near("channel", "acceleration by V div(tau) [m/s2]", slope, -g / rho_s, 1e-6, run)
        inertia = rho_s * spheres.volume(d) * d**2 / 10
        energy = run.history["kinetic_energy_J"][-1] - 0.5 * rho_s * spheres.volume(d) * v[-1] ** 2
        spin = math.sqrt(2 * energy / inertia)
        self.near("channel", "spin of the sphere [rad/s]", spin, g * (h / 2 - z) / (2 * mu), 1e-3, run)

    def test_stress_and_spin(self) -> None:
        self.drifts()

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        self.drifts("--ranks-fluid", "2")


if __name__ == "__main__":
    unittest.main()
