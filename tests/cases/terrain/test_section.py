"""Sections against the figures that define them, by sampling every centimetre."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch.terrain.profile import read_section

from .scene import FIGURES, LAKE, section


class Areas(unittest.TestCase):
    def setUp(self):
        self.samples = {}
        for name in FIGURES:
            s = section(name)
            x = np.arange(0, s.bank_end, 0.01) + 0.005
            self.samples[name] = (x, s.height(x), s.ground_height(x), s)

    def test_slide(self):
        for name, figures in FIGURES.items():
            x, base, ground, s = self.samples[name]
            thickness = (ground - base)[x < s.toe[0]]
            area = thickness.sum() * 0.01
            self.assertAlmostEqual(area, figures.slide_area, delta=1)
            self.assertAlmostEqual(s.slide_area(), figures.slide_area, delta=1)
            self.assertAlmostEqual(thickness.mean(), figures.mean_thickness, delta=0.6)
            self.assertAlmostEqual(thickness.max(), figures.largest_thickness, delta=0.6)
            below = np.clip(np.minimum(ground, LAKE) - base, 0, None).sum() * 0.01
            self.assertAlmostEqual(below / area, figures.below_lake, delta=0.006)

    def test_water(self):
        for name, figures in FIGURES.items():
            x, _, ground, _ = self.samples[name]
            depth = np.clip(LAKE - ground, 0, None)
            self.assertAlmostEqual(depth.sum() * 0.01, figures.water_area, delta=6)
            self.assertAlmostEqual((depth > 0).sum() * 0.01, figures.water_width, delta=6)
            self.assertAlmostEqual(depth.max(), figures.water_depth, delta=1)

    def test_shores_lie_on_the_lake_level(self):
        for name in FIGURES:
            shores = section(name).shores()
            self.assertEqual(len(shores), 2)
            np.testing.assert_allclose(section(name).height(np.array(shores)), LAKE, atol=1e-9)

    def test_seat_is_a_parameter(self):
        s = section("east")
        raised = read_section("cases/vajont_east/geometry/profile.toml", LAKE, 10, seat_shift=20)
        self.assertEqual(raised.height(1000) - s.height(1000), 20)
        self.assertEqual(raised.height(300), s.height(300))
        np.testing.assert_array_equal(raised.toe, s.toe)


class BadFiles(unittest.TestCase):
    def read(self, text):
        with tempfile.TemporaryDirectory() as place:
            path = Path(place) / "profile.toml"
            path.write_text(text)
            return read_section(path, LAKE, 10)

    def test_refused_with_the_reason(self):
        good = ("failure = [[0, 100], [50, 20], [100, 0]]\n"
                "ground = [[0, 100], [60, 80], [100, 0]]\nbank = [[100, 0], [200, 90]]\n")
        self.read(good)
        for old, new, reason in (
            ("failure", "failed", "'failure' is missing"),
            ("[60, 80]", "[60, 5]", "below the failure surface"),
            ("bank = [[100, 0]", "bank = [[100, 1]", "'bank' must begin"),
            ("[50, 20]", "[0, 20]", "x must rise"),
            ("= [[0, 100], [60", "= [[0, 101], [60", "'ground' must begin"),
            ("bank = ", "bank = [", "cannot be read"),
        ):
            with self.assertRaisesRegex(ValueError, reason):
                self.read(good.replace(old, new, 1))


if __name__ == "__main__":
    unittest.main()
