"""Forces beside drag with both real engines, against closed forms."""

import math
import os
import unittest

import numpy as np
from scipy.optimize import brentq

from tests.cases.verification import spheres
from tests.cases.verification.runs import Run, Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


class VirtualMass(Verification):
    """A sphere in a fluid that speeds up, and free particles that slow down in fluid that they take along."""

    def follows(self, ratio: float, law: str, c: float) -> None:
        """v = a t (1 + C)/(rho_s/rho_f + C); 1e-6: the flow is uniform but for the inlet's cell, whose
        error has not come to the sphere's."""
        run = self.run_case("accelerated", parameters__solid_density=1000 * ratio, models__virtual_mass=law,
                            force=True)
        expected = 3.0 * (1 + c) / (ratio + c) * run.history["time_s"]
        error = np.abs(run.history["one_vz_m_s"] - expected).max() / expected[-1]
        self.near(f"accelerated fluid, rho_s/rho_f {ratio:g}, virtual mass {law}", "largest error of v(t)",
                  error, 0, 1e-6, run)

    def slows_down(self, law: str, x: float, window: float, tolerance: float) -> None:
        """Per volume eps rho u' = -B, phi rho_s v' = B, B = n (K (u - v) + C rho V (u' - v')): the slip falls
        at L n K/(1 + L C rho phi), L = 1/(eps rho) + 1/(phi rho_s). The closed form wants a K that stays:
        Stokes' coefficient, and so slow (Re 0.006) that Di Felice's exponent makes it 3e-4 less."""
        phi, d, rho_s, rho, speed, time_s = 0.303, 1e-3, 2650.0, 1000.0, 1e-5, 0.04
        eps = 1 - phi
        c = {"none": 0.0, "constant": 0.5, "zuber": 0.5 * (1 + 2 * phi) / (1 - phi)}[law]
        spacing = d * (math.pi / 6 / phi) ** (1 / 3)
        drag = x * rho_s * spheres.volume(d) / window
        run = self.run_case(
            "suspension", parameters__spacing=spacing, coupling__window=window, coupling__regime="mild",
            parameters__fluid_viscosity=spheres.stokes_viscosity(drag, eps, d), parameters__fluid_density=rho,
            parameters__speed=speed, coupling__smoothing_length=2.4 * spacing, models__virtual_mass=law,
            models__drag_coefficient="stokes", case__end_time=time_s, output__interval=time_s, force=True)
        both = 1 / (eps * rho) + 1 / (phi * rho_s)
        rate = both * phi / spheres.volume(d) * drag / (1 + both * c * rho * phi)
        mixture = phi * rho_s * speed / (phi * rho_s + eps * rho)
        v = mixture + (speed - mixture) * np.exp(-rate * run.history["time_s"])
        error = np.abs(run.history["one_vz_m_s"] - v).max() / (speed - mixture)
        case = f"suspension, virtual mass {law}, K W/m {x:g}"
        self.near(case, "largest error of v(t) over the fall", error, 0, tolerance, run)
        self.budgets_close(case, run)
        # Momentum of both, with what the particles have still to receive: none is lost. 1e-9: one particle
        # stands for all, and cells differ by what the solvers leave.
        owed = run.history["ledger_z_kg_m_s"][-1] / (64 * spacing**3)
        kept = phi * rho_s * run.history["one_vz_m_s"][-1] + eps * rho * run.field("U")[:, 2].mean() + owed
        self.near(case, "momentum over the first", kept / (phi * rho_s * speed), 1, 1e-9, run)

    def test_light_sphere_follows(self) -> None:
        self.follows(0.1, "constant", 0.5)

    def test_suspension(self) -> None:
        """0.5 %: the window's lag, first order in K W/m (halving the window halves it: full)."""
        self.slows_down("constant", 0.01, 5e-4, 0.005)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for ratio in (0.5, 1.0, 2.65):
            for law, c in (("none", 0.0), ("constant", 0.5)):
                self.follows(ratio, law, c)
        for law in ("none", "constant", "zuber"):
            self.slows_down(law, 0.01, 5e-4, 0.005)
            self.slows_down(law, 0.005, 2.5e-4, 0.0025)


class Formulations(Verification):
    """A and B in a bed that is held and in one that settles: the same pressure drop, force and speed."""

    # Layers, and how long the kernel is: the ends' own void fraction must not reach the middle, where both
    # formulations are compared. (The fluid carries eps of the cell, K/eps has the particle's: where eps is
    # not uniform A and B differ by the kernel, 4e-5 in 25 layers with a kernel of 3.2.)
    LAYERS, KERNEL = 51, 1.6

    def flows(self, reynolds: float, formulation: str, layers: int) -> tuple[float, float, float, Run]:
        """-dp/dz and U in the middle, and the whole force on the particles: their drag, and in A V grad p."""
        size, mu, rho, spacing = 1e-3, 1e-3, 1000.0, 1e-3
        diameter = spacing * (0.6 * 6 / math.pi) ** (1 / 3)
        run = self.run_case("fixed_bed", parameters__diameter=diameter, parameters__layers=layers,
                            parameters__inlet_velocity=reynolds * mu / (rho * size) / 0.4,
                            coupling__regime="mild", coupling__smoothing_length=self.KERNEL * spacing,
                            models__formulation=formulation, force=True)
        p = run.probe("p")[-1, 1:] * rho
        gradient = (p[0] - p[1]) / (10 * spacing)
        force = run.history["received_z_kg_m_s"][-1] / (run.history["time_s"][-1] - run.history["time_s"][-2])
        if formulation == "A":
            force += 9 * layers * spheres.volume(diameter) * gradient
        return gradient, run.field("U")[layers // 2, 2], force, run

    def same(self, reynolds: float) -> None:
        """1e-6: the solvers. What the ends add to the force is the same in beds of two lengths, so that their
        difference is that of ten layers in the middle."""
        eps, spacing, mu, rho = 0.4, 1e-3, 1e-3, 1000.0
        diameter = spacing * (0.6 * 6 / math.pi) ** (1 / 3)
        found = {}
        for formulation in "AB":
            _, _, shorter, _ = self.flows(reynolds, formulation, self.LAYERS - 10)
            gradient, u, longer, run = self.flows(reynolds, formulation, self.LAYERS)
            case = f"fixed_bed, formulation {formulation}, Re {reynolds:g}"
            law = spheres.di_felice(eps, u, diameter, rho, mu) * u / eps  # f_B = f_A/eps, on one particle
            self.near(case, "pressure drop over the law's [Pa/m]", gradient, law / spacing**3, 1e-6, run)
            self.near(case, "force on 90 particles over the law's [N]", longer - shorter, 90 * law, 1e-6, run)
            found[formulation] = gradient, longer - shorter
        case = f"fixed_bed, B against A, Re {reynolds:g}"
        for k, quantity in enumerate(("pressure drop [Pa/m]", "force on 90 particles [N]")):
            self.near(case, quantity, found["B"][k], found["A"][k], 1e-6, run)

    def settles(self, phi: float) -> None:
        """Closed column, K W/m 0.1: K_A s/eps = (rho_s - rho_f) V g in both, the fluid rises between the
        spheres; 1 %: how far from its end the fall still is, as in test_beds."""
        eps, d, rho_s, rho_f, g, window, x = 1 - phi, 1e-3, 2650.0, 1000.0, 1.0, 1e-3, 0.1
        spacing = d * (math.pi / 6 / phi) ** (1 / 3)
        mu = spheres.stokes_viscosity(x * rho_s * spheres.volume(d) / window, eps, d)
        run = self.run_case("hindered_settling", parameters__spacing=spacing, parameters__fluid_viscosity=mu,
                            coupling__smoothing_length=2.4 * spacing, case__end_time=0.12,
                            output__interval=0.12, models__formulation="B", force=True)
        push = eps * (rho_s - rho_f) * g * spheres.volume(d)
        slip = brentq(lambda s: spheres.di_felice(eps, s, d, rho_f, mu) * s - push, 0, 10)
        case = f"hindered_settling, formulation B, fraction {phi:g}"
        self.near(case, "speed over the law's [m/s]", -run.history["one_vz_m_s"][-1], eps * slip, 0.01, run)
        self.budgets_close(case, run)

    def test_same_bed(self) -> None:
        self.same(1.0)

    def test_settling(self) -> None:
        self.settles(0.3)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for reynolds in (0.1, 10.0, 100.0):
            self.same(reynolds)
        for phi in (0.05, 0.5):
            self.settles(phi)


class Channel(Verification):
    """Plane Poiseuille flow, -dp/dx = G: div(tau) = -G everywhere, curl u = G (h/2 - z)/mu across. Taken
    after 15 times of its slowest mode."""

    G, MU, H, RHO, D, Z = 2000.0, 0.01, 0.01, 1.0, 5e-4, 0.00225
    SPIN = G * (H / 2 - Z) / MU

    def slope(self, run: Run, column: str) -> float:
        """Acceleration over the second half of the run."""
        half = len(run.history["time_s"]) // 2
        t, v = run.history["time_s"][half:], run.history[column][half:]
        return (v[-1] - v[0]) / (t[-1] - t[0])

    def drifts(self, *words: str) -> None:
        """1e-6: the flow's slowest mode is at 1e-7 of its start on average. Spin from the energy; second
        differences and the curl are exact on a parabola."""
        rho_s = 1000.0
        run = self.run_case("channel", *words, force=True)
        self.near("channel", "acceleration by V div(tau) [m/s2]", self.slope(run, "one_vx_m_s"), -self.G / rho_s,
                  1e-6, run)
        mass = rho_s * spheres.volume(self.D)
        energy = run.history["kinetic_energy_J"][-1] - 0.5 * mass * run.history["one_vx_m_s"][-1] ** 2
        spin = math.sqrt(2 * energy / (mass * self.D**2 / 10))
        self.near("channel", "spin of the sphere [rad/s]", spin, self.SPIN / 2, 1e-6, run)

    def lifts(self) -> None:
        """A sphere so heavy that it stays; 1e-5: its own motion, 4e-4 of the slip, turns the lift by as much.
        The fluid's velocity is read from its cell."""
        rho_s = 1e6
        run = self.run_case("channel", models__viscous_force="false", models__torque="none",
                            models__lift="saffman_mei", parameters__solid_density=rho_s, force=True)
        u = run.field("U")[2 + 4 * 4, 0]
        s = math.sqrt(self.MU / self.RHO * self.SPIN) / u
        mei = 0.3 * (1 + math.tanh(2.5 * (math.log10(s) + 0.191))) * (0.667 + math.tanh(6 * (s - 0.32)))
        lift = 1.615 * self.D**2 * self.RHO * math.sqrt(self.MU / self.RHO * self.SPIN) * u * mei
        self.near("channel, lift", "acceleration across [m/s2]", self.slope(run, "one_vz_m_s"),
                  lift / (rho_s * spheres.volume(self.D)), 1e-5, run)

    def test_stress_and_spin(self) -> None:
        self.drifts()

    def test_lift(self) -> None:
        self.lifts()

    def test_lift_on_the_fluid(self) -> None:
        """Two-way: what the particle receives is what the fluid gives, with nothing left for the ledger."""
        run = self.run_case("channel", models__viscous_force="false", models__torque="none",
                            models__lift="saffman_mei", coupling__reaction="two_way", coupling__regime="mild",
                            coupling__smoothing_length=4e-3, parameters__solid_density=1e6,
                            case__end_time=0.01, output__interval=0.01, force=True)
        self.budgets_close("channel, lift, two-way", run)
        received = np.abs(run.history["received_z_kg_m_s"]).sum()
        self.assertGreater(received, 0)
        owed = np.abs(run.history["ledger_z_kg_m_s"]).max() / received
        self.near("channel, lift, two-way", "ledger over what was received", owed, 0, 1e-10, run)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        self.drifts("--ranks-fluid", "2")


class ShearBox(Verification):
    """Lift of a grain in a periodic box: the fluid across gains the impulse that the grain gains, reversed. 2e-6: a
    window of a hundred of the pressure's share, 2e-4; the impulse against Saffman and Mei 1e-3: that share, and the
    grain's drift through the shear, 1e-4."""

    def test_impulse(self) -> None:
        d, cell, rho, rho_s, nu, shear, slip, end = 1e-4, 1e-3, 1000.0, 1e7, 1e-6, 10.0, 0.005, 0.1
        run = self.run_case("shear_box")
        s = math.sqrt(nu * shear) / slip
        mei = 0.3 * (1 + math.tanh(2.5 * (math.log10(s) + 0.191))) * (0.667 + math.tanh(6 * (s - 0.32)))
        impulse = -1.615 * d**2 * rho * math.sqrt(nu * shear) * slip * mei * end
        gained = rho_s * spheres.volume(d) * run.history["one_vz_m_s"][-1]
        fluid = rho * cell**3 * (run.field("eps") * run.field("U")[:, 2]).sum()
        self.near("shear_box", "impulse of the lift [N s]", gained, impulse, 1e-3, run)
        self.near("shear_box", "momentum of the fluid across [N s]", fluid, -gained, 2e-6, run)
        self.budgets_close("shear_box", run)


if __name__ == "__main__":
    unittest.main()
