"""Angle of repose against rolling resistance, by discharge from a plate (plate_discharge.py).

Reference: the fit of Zhou et al. 2002 to their simulations (scatter 2 degrees) and experiments with glass
beads. Their law of rolling is another, a constant moment against each sphere's own spin, ours a spring
with a slider against the difference of spins: 20 % are allowed where both are known, eta 0.05 to 0.2, and
the angle must rise throughout."""

import tempfile
import unittest
from pathlib import Path

from launch import verification
from tests.dem_side.plate_discharge import discharge, zhou

ETAS = 0, 0.02, 0.05, 0.1, 0.2
COMPARED = 0.05, 0.1, 0.2
TOLERANCE = 0.2
AT_REST_J = 1e-6 * 2000 * 1.3e-3 * 9.81 * 0.15  # of what the bed held


class Repose(unittest.TestCase):
    def test_rises_with_rolling_resistance_as_published(self) -> None:
        angles = []
        for eta in ETAS:
            with tempfile.TemporaryDirectory() as place:
                heap = discharge(Path(place), f"iwashita_oda kr 0.05 eta {eta}" if eta else "")
            angles.append(heap.angle)
            print(f"eta {eta}: {heap}, Zhou et al. {zhou(eta):.1f}")
            if eta in COMPARED:
                self.assertLess(heap.kinetic_J, AT_REST_J)
                verification.record("angle of repose", f"eta = {eta:g} [degrees]", heap.angle, zhou(eta),
                                    TOLERANCE, heap.wall_s)
                with self.subTest(eta=eta):
                    self.assertLess(abs(heap.angle / zhou(eta) - 1), TOLERANCE)
        for low, high in zip(angles, angles[1:]):
            self.assertLess(low + 2, high, angles)


if __name__ == "__main__":
    unittest.main()
