"""Beds and suspensions with both real engines: pressure drop, settling, fluidisation, seepage.

References are typed in or written down in spheres.py from the publications; nothing of slidewave's
own closures is used."""

import math
import os
import unittest

import numpy as np
from scipy.optimize import brentq

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ
SPACING = 1e-3

# Ergun (1952), dp/L [Pa/m] = 150 mu (1 - eps)^2/(eps^3 d^2) Us + 1.75 rho (1 - eps)/(eps^3 d) Us^2,
# worked out by hand for water and d = 1 mm, eps = 0.4, by Reynolds number rho Us d/mu.
ERGUN = {0.1: 84.539, 1.0: 860.16, 10.0: 10078.1, 100.0: 248437.5}


class FixedBed(Verification):
    """Pressure read from the field, spheres held."""

    def presses(self, reynolds: float) -> None:
        eps, size, diameter, mu, rho = 0.4, 1e-3, SPACING * (0.6 * 6 / math.pi) ** (1 / 3), 1e-3, 1000.0
        flux = reynolds * mu / (rho * size)
        # Ergun's numbers are for spheres of 1 mm; the lattice's are larger, so the fluid is scaled to
        # the same Reynolds number, and the pressure back.
        mu_here = mu * diameter / size
        run = self.run_case("fixed_bed", parameters__diameter=diameter, parameters__fluid_viscosity=mu_here,
                            parameters__inlet_velocity=flux / eps, models__drag_coefficient="dalla_valle")
        p = run.probe("p")[-1, 1:] * rho
        gradient = (p[0] - p[1]) / (10 * SPACING)
        case = f"fixed_bed, Re {reynolds:g}"
        law = spheres.darcy_pressure(np.array([eps]), flux, 1.0, diameter, rho, mu_here,
                                     spheres.dalla_valle_cd_re)
        self.near(case, "pressure drop over the law's [Pa/m]", gradient, law, 0.01, run)
        # mu d and rho d: both terms of Ergun scale with 1/d at the same Reynolds and superficial speed
        self.near(case, "pressure drop over Ergun's [Pa/m]", gradient * diameter / size, ERGUN[reynolds],
                  0.15, run)
        self.assertGreater(abs(gradient / eps / law - 1), 1, "the wrong exponent would be seen")

    def test_reynolds_1(self) -> None:
        self.presses(1.0)

    def test_reynolds_100(self) -> None:
        self.presses(100.0)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for reynolds in ERGUN:
            self.presses(reynolds)


class PlugFlow(Verification):
    """Through both ends of a bed without drag. The flux on the faces is uniform; the cells' velocity
    departs from it by the truncation error of the convection scheme, linearUpwind's 3/8 dx^2 U'': 2 % with
    a kernel of three cells, a fourth of that with one of six. (With the old flux compared as a velocity, as
    in a fluid without pores, it was 3.6 %.)"""

    def passes(self, cells: float, tolerance: float) -> None:
        inlet, rho = 0.1, 1000.0
        run = self.run_case("plug_flow", coupling__smoothing_length=cells * SPACING)
        eps, u, p = run.field("eps"), run.field("U")[:, 2], run.field("p") * rho
        case = f"plug_flow, kernel {cells:g} cells"
        self.assertLess(eps[20], 0.6)
        self.near(case, "largest error of the flux eps U over the inlet's", np.abs(eps * u / inlet - 1).max(), 0,
                  tolerance, run)
        # Bernoulli: only the steps of the void fraction act on the flow
        lost = 0.5 * rho * ((inlet / eps[20]) ** 2 - inlet**2)
        self.near(case, "pressure lost to the narrower way [Pa]", p[2] - p[20], lost, 0.02, run)

    def test_kernel_of_three_cells(self) -> None:
        self.passes(3, 0.02)

    def test_kernel_of_six_cells(self) -> None:
        self.passes(6, 0.005)


class HinderedSettling(Verification):
    """Speed of a suspension in a closed column."""

    def settles(self, phi: float, x: float) -> float:
        eps, diameter, rho_s, rho_f, g, window = 1 - phi, 1e-3, 2650.0, 1000.0, 1.0, 1e-3
        spacing = diameter * (math.pi / 6 / phi) ** (1 / 3)
        mass = rho_s * spheres.volume(diameter)
        mu = spheres.stokes_viscosity(x * mass / window, eps, diameter)
        end = window * math.ceil(max(20.0, 12 / x))
        run = self.run_case("hindered_settling", parameters__spacing=spacing, parameters__fluid_viscosity=mu,
                            coupling__smoothing_length=2.4 * spacing, case__end_time=end, output__interval=end)
        push = eps * (rho_s - rho_f) * g * spheres.volume(diameter)  # of the mixture's buoyancy
        slip = brentq(lambda s: spheres.di_felice(eps, s, diameter, rho_f, mu) * s - push, 0, 10)
        speed = -float(run.history["one_vz_m_s"][-1])
        case = f"hindered_settling, fraction {phi:g}, K W/m {x:g}"
        self.near(case, "speed over the law's [m/s]", speed, eps * slip, 0.01, run)
        self.budgets_close(case, run)
        self.terminal = slip
        return speed * mu  # at one viscosity

    def slope(self, fractions: list[float], x: float) -> None:
        speeds = [self.settles(phi, x) for phi in fractions]
        n = np.polyfit(np.log(1 - np.array(fractions)), np.log(speeds), 1)[0]
        run = self.run_case("hindered_settling")
        self.near(f"hindered_settling, K W/m {x:g}", "Richardson and Zaki's exponent", n, 4.65, 0.05, run)

    def test_slope(self) -> None:
        self.slope([0.05, 0.4], 10)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for x in (0.1, 1, 100):
            self.slope([0.05, 0.1, 0.2, 0.3, 0.4, 0.5], x)


class FluidisedBed(Verification):
    def test_knee_and_plateau(self) -> None:
        d, layers, rho_s, rho_f, mu, g = 1e-3, 60, 2650.0, 1000.0, 1e-3, 9.81
        run = self.run_case("fluidised_bed")
        rows = run.probe("p")
        time, drop = rows[:, 0], (rows[:, 1] - rows[:, 2]) * rho_f
        flux = 0.03 * time / time[-1]
        weight = layers * (rho_s - rho_f) * spheres.volume(d) * g / SPACING**2
        eps = 1 - math.pi / 6
        law = brentq(lambda us: spheres.darcy_pressure(np.full(layers, eps), us, SPACING, d, rho_f, mu)
                     - 0.9 * weight, 1e-6, 1.0)
        last = flux > 1.15 * law
        self.near("fluidised_bed", "pressure drop over the bed's submerged weight [Pa]",
                  drop[last].mean(), weight, 0.02, run)
        knee = flux[np.argmax(drop > 0.9 * weight)]
        self.near("fluidised_bed", "flow at which nine tenths of the bed are carried [m/s]", knee, law, 0.1, run)
        self.budgets_close("fluidised_bed", run)


class Seepage(Verification):
    def test_relief_and_heave(self) -> None:
        d, layers, rho_s, rho_f, g, kn = 1e-3, 24, 2650.0, 1000.0, 9.81, 100.0
        weight = (rho_s - rho_f) * spheres.volume(d) * g  # of a sphere, submerged
        critical = layers * weight / SPACING**2  # Pa over the bed
        last = 1.1 * critical / rho_f
        run = self.run_case("seepage", parameters__pressure_last=last)
        rows = run.probe("p")
        time, p = rows[:, 0], rows[:, 1:] * rho_f
        below = last * rho_f * time / time[-1]
        share = below / critical
        # the top's sinking under the bed's own weight, all of which seepage relieves at the critical
        # pressure: contacts j = 0 (floor) to layers - 1 carry layers - j spheres
        sunk = weight / kn * layers * (layers + 1) / 2
        rise = np.interp(time, run.history["time_s"], run.history["one_z_m"] - run.history["one_z_m"][0])
        half = np.argmax(share > 0.5)
        self.near("seepage", "rise of the top at half the critical pressure, over the sinking", rise[half] / sunk,
                  0.5, 0.02, run, absolute=True)
        # As the pressure rises the bed still swells: what the flow loses to that is largest at first.
        inside = (layers - np.array([6.5, 12.5, 18.5])) / layers
        linear = np.abs(p / below[:, None] - inside)[(share > 0.5) & (share < 0.95)]
        self.near("seepage", "largest departure from a linear pressure", linear.max(), 0, 0.01, run)
        heave = float(share[np.argmax(rise > 1.05 * sunk)])
        self.near("seepage", "heave over the critical gradient (1 - eps)(rho_s/rho_f - 1)", heave, 1, 0.05, run)


class Consolidation(Verification):
    """Terzaghi's series for a column drained at one end."""

    @staticmethod
    def series(tv: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Pressure at the base over the first, and degree of settlement."""
        m = (2 * np.arange(200) + 1) * np.pi / 2
        decay = np.exp(-np.outer(tv, m**2))
        sign = (-1.0) ** np.arange(200)
        return (2 * sign / m * decay).sum(axis=1), 1 - (2 / m**2 * decay).sum(axis=1)

    def consolidates(self, layers: int, x: float, stiffness: float, tolerance: float) -> None:
        d, rho_s, window = 1e-3, 2650.0, 1e-3
        eps = 1 - math.pi / 6
        mass = rho_s * spheres.volume(d)
        mu = spheres.stokes_viscosity(x * mass / window, eps, d)
        kn = stiffness * mass / window**2
        load = 1e-7 * kn * d  # so gently that drag is Stokes'
        mobility = eps**2 * SPACING**3 / (x * mass / window)
        cv = mobility * kn / SPACING
        height = layers * SPACING
        end = window * math.ceil(0.9 * height**2 / cv / window)
        steps = max(4, math.ceil(window / (0.25 * math.sqrt(mass / kn))))
        run = self.run_case("consolidation", parameters__layers=layers, parameters__fluid_viscosity=mu,
                            parameters__contact_stiffness=kn, parameters__load=load, observe__one__id=4 * layers,
                            parameters__dem_dt=window / steps, case__end_time=end, output__interval=end)
        time = run.history["time_s"]
        tv = cv * time / height**2
        settled = -(run.history["one_z_m"] - run.history["one_z_m"][0]) / (layers * load / kn)
        base = np.interp(time, *run.probe("p").T) * 1000.0 / (load / SPACING**2)
        pressure, degree = self.series(tv)
        case = f"consolidation, {layers} spheres, K W/m {x:g}"
        for mark in (0.1, 0.2, 0.5, 0.8):
            k = int(np.argmax(tv >= mark))
            self.near(case, f"settlement at Tv {mark:g}", settled[k], degree[k], tolerance, run)
            self.near(case, f"pressure at the base at Tv {mark:g}", base[k], pressure[k], tolerance, run)
        self.budgets_close(case, run)

    def test_hundred(self) -> None:
        self.consolidates(100, 1, 125, 0.05)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        self.consolidates(200, 1, 500, 0.05)
        self.consolidates(100, 100, 1.25e4, 0.05)


if __name__ == "__main__":
    unittest.main()
