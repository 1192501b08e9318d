"""Terminal speeds of single spheres, Reynolds numbers 0.001 to 1139, undisturbed fluid."""

import os
import unittest

from tests.cases.verification.runs import Verification

FULL = "SLIDEWAVE_VERIFICATION" in os.environ

# name: diameter [m], solid density, fluid density [kg/m3], viscosity [Pa s], speed [m/s] of Brown and
# Lawler's coefficient, worked out for the project's dossier (PHYSICS.md, F2); the four of ten Cate et
# al. (2002) are for an unbounded fluid.
SPHERES = {
    "sand in oil": (1e-4, 2650, 1000, 0.1, 0.0900e-3),
    "1 mm of sand in water": (1e-3, 2650, 1000, 1e-3, 156.8e-3),
    "3 mm of gravel in water": (3e-3, 2650, 1000, 1e-3, 379.5e-3),
    "ten Cate, Re 1.5": (15e-3, 1120, 970, 0.373, 40.9e-3),
    "ten Cate, Re 4.1": (15e-3, 1120, 965, 0.212, 63.7e-3),
    "ten Cate, Re 11.6": (15e-3, 1120, 962, 0.113, 94.3e-3),
    "ten Cate, Re 31.9": (15e-3, 1120, 960, 0.058, 130.1e-3),
}


class Terminal(Verification):
    """0.5 %: the dossier gives three or four digits."""

    def falls(self, name: str) -> None:
        diameter, solid, fluid, viscosity, speed = SPHERES[name]
        response = speed / (9.81 * (1 - fluid / solid))  # time to reach it at full weight
        window = response / 10
        # Nothing is touched, but the check wants contacts that an impact at this speed would not crush.
        stiffness = 200 * solid * diameter**3 / 2 * (speed / diameter) ** 2
        step = min(window, 0.2 * diameter / speed / 200**0.5)
        run = self.run_case("terminal", parameters__diameter=diameter, parameters__solid_density=solid,
                            uniform_flow__density=fluid, uniform_flow__viscosity=viscosity,
                            parameters__room=40 * diameter + 12 * response * speed, coupling__window=window,
                            parameters__dem_dt=window / -(-window // step), case__end_time=120 * window,
                            output__interval=120 * window, check__speed=speed,
                            parameters__contact_stiffness=stiffness)
        self.near("terminal", f"{name}: speed [m/s]", -run.history["one_vz_m_s"][-1], speed, 0.005, run)

    def test_sand(self) -> None:
        self.falls("1 mm of sand in water")

    def test_creeping(self) -> None:
        self.falls("sand in oil")

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        for name in SPHERES:
            self.falls(name)


if __name__ == "__main__":
    unittest.main()
