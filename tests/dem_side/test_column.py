"""Dry column collapse and slope of the deposit (column_collapse.py). Quick: one column, and the slope
against rolling resistance. Full: four aspect ratios with grains of three sizes, a row each."""

import tempfile
import unittest
from pathlib import Path

from launch import verification
from tests.dem_side.column_collapse import Outcome, collapse, lajeunesse, lube

# Rolling resistance of angular grains (Jiang 2015, b = 0.4): slopes of 25 to 30 degrees, as of sand.
SAND = "shape 0.4 crushing 2.1"


def column(aspect: float, length: float, diameter: float, rolling: str = SAND) -> Outcome:
    with tempfile.TemporaryDirectory() as place:
        return collapse(Path(place), aspect, length, diameter, rolling=rolling)


class Quick(unittest.TestCase):
    def test_run_out_of_one_column(self) -> None:
        outcome = column(1, 14, 1)
        reference = lube(outcome.aspect)
        verification.record("dry column collapse", f"run-out, a = {outcome.aspect:.2f}", outcome.run_out,
                            reference, 0.25, outcome.wall_s)
        self.assertLess(abs(outcome.run_out / reference - 1), 0.25, outcome)

    def test_slope_rises_with_rolling_resistance(self) -> None:
        slopes = [column(1, 10, 1, f"shape {b} crushing 2.1" if b else "").slope for b in (0, 0.25, 0.5)]
        self.assertLess(slopes[0] + 3, slopes[1], slopes)
        self.assertLess(slopes[1] + 3, slopes[2], slopes)
        self.assertGreater(slopes[2], 20, slopes)
        self.assertLess(slopes[2], 40, slopes)


class Full(unittest.TestCase):
    """Lube and Lajeunesse differ by half below a = 3: within 25 % of the span between them."""

    def test_four_aspect_ratios_and_three_sizes(self) -> None:
        for aspect, length in ((0.5, 20), (1, 14), (2.2, 10), (5, 8)):
            for alpha, tolerance in ((1, 0.25), (2, 0.25), (4, 0.5)):
                outcome = column(aspect, length, 0.5 * alpha)
                low, high = sorted((lube(outcome.aspect), lajeunesse(outcome.aspect)))
                reference = min(max(outcome.run_out, low), high)
                verification.record("dry column collapse", f"run-out, H0/L0 = {aspect}, alpha = {alpha}",
                                    outcome.run_out, reference, tolerance, outcome.wall_s)
                with self.subTest(aspect=aspect, alpha=alpha):
                    self.assertLess(abs(outcome.run_out / reference - 1), tolerance, outcome)


if __name__ == "__main__":
    unittest.main()
