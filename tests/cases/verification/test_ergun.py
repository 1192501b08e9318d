"""The bed of CFDEMcoupling's ErgunTestMPI (spheres of 1 mm, 2000 kg/m3, in a gas of 10 kg/m3 and 1.5e-4 m2/s,
Koch and Hill's drag): there the pressure drop changes by 1.3 to 3.9 % with the number of ranks, and is compared
with a porosity (0.4513) that is not the bed's. Here porosity and weight are the bed's own, and the number of
ranks must change nothing."""

import math
import os
import unittest

from tests.cases.verification import spheres
from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ
SPACING, DENSITY, VISCOSITY, SOLID = 1e-3, 10.0, 1.5e-3, 2000.0
GAS = {"parameters__fluid_density": DENSITY, "parameters__fluid_viscosity": VISCOSITY,
       "parameters__solid_density": SOLID, "models__drag": "koch_hill"}


def koch_hill_gradient(eps: float, flux: float, diameter: float) -> float:
    """-dp/dz [Pa/m] of the dense law, Hill, Koch and Ladd (2001), for a superficial velocity `flux`."""
    phi = 1 - eps
    f0 = 10 * phi / eps**3
    f3 = 0.0673 + 0.212 * phi + 0.0232 / eps**5
    reynolds = DENSITY * flux * diameter / VISCOSITY
    beta = 18 * VISCOSITY * eps**2 * phi / diameter**2 * (f0 + 0.5 * f3 * reynolds)
    return beta * flux / eps**2


class ErgunBed(Verification):
    def test_ranks_change_nothing(self) -> None:
        eps, flux = 0.425, 0.006  # middle of what the packed bed has; half of what lifts it
        diameter = SPACING * ((1 - eps) * 6 / math.pi) ** (1 / 3)
        drops = {}
        for ranks in (1, 2, 4):
            run = self.run_case("fixed_bed", "--ranks-fluid", str(ranks), "--ranks-dem", "1",
                                parameters__diameter=diameter, parameters__inlet_velocity=flux / eps,
                                case__end_time=0.005, output__interval=0.005, **GAS)
            p = run.probe("p")[-1, 1:] * DENSITY
            drops[ranks] = (p[0] - p[1]) / (10 * SPACING)
        self.near("Ergun bed, held", "pressure gradient over Koch and Hill's [Pa/m]", drops[1],
                  koch_hill_gradient(eps, flux, diameter), 0.01, run)
        for ranks in (2, 4):
            self.near(f"Ergun bed, held, {ranks} ranks", "pressure gradient over that of one [Pa/m]",
                      drops[ranks], drops[1], 1e-8, run)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        layers, g = 60, 9.81
        weight = layers * (SOLID - DENSITY) * spheres.volume(1e-3) * g / SPACING**2
        for ranks in (1, 2, 4):
            run = self.run_case("fluidised_bed", "--ranks-fluid", str(ranks), "--ranks-dem", "1", **GAS)
            rows = run.probe("p")
            time, drop = rows[:, 0], (rows[:, 1] - rows[:, 2]) * DENSITY
            carried = time > 0.85 * time[-1]
            self.near(f"Ergun bed, fluidised, {ranks} ranks", "pressure drop over the bed's submerged weight [Pa]",
                      drop[carried].mean(), weight, 0.02, run)
            self.budgets_close(f"Ergun bed, fluidised, {ranks} ranks", run)


if __name__ == "__main__":
    unittest.main()
