"""Lattices that a script fills, and how densely particles lie, against closed forms."""

import math
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import dem_lattice, dem_script, scene_packing

BOX = np.array([[0.0, 0, 0], [4, 4, 4]])


def lattice(style: str, constant: float) -> np.ndarray:
    return dem_lattice.positions([style, str(constant), "origin", "0.25", "0.25", "0.25"], BOX, BOX)


class Lattice(unittest.TestCase):
    def test_numbers_and_nearest_neighbours(self) -> None:
        for style, number, nearest in (("sc", 64, 1.0), ("bcc", 128, math.sqrt(3) / 2), ("fcc", 256, math.sqrt(0.5))):
            points = lattice(style, 1.0)
            self.assertEqual(len(points), number, style)
            apart = np.linalg.norm(points[1:] - points[0], axis=1).min()
            self.assertAlmostEqual(apart, nearest, msg=style)

    def test_region_with_open_sides(self) -> None:
        region = np.array([[np.nan, np.nan, 1], [np.nan, np.nan, 2]])
        self.assertEqual(len(dem_lattice.positions(["sc", "1"], region, BOX)), 16)

    def test_unknown_is_none(self) -> None:
        for words in (["hex", "1"], ["sc", "1", "orient", "x", "1"], ["sc", "one"], ["sc", "0"], ["sc", "1e-9"], []):
            self.assertIsNone(dem_lattice.positions(words, BOX, BOX), words)
        self.assertIsNone(dem_lattice.positions(["sc", "1"], None, BOX))

    def test_script(self) -> None:
        text = ("region b block 0 4 0 4 0 4 units box\ncreate_box 1 b\nlattice sc 1\nregion r block INF INF INF INF 1 3 units box\n"
                "create_atoms 1 region r\nset group all diameter 0.5 density 2650\n")
        with tempfile.TemporaryDirectory() as place:
            script = Path(place) / "in"
            for more, number in (("", 32), ("delete_atoms group x\n", None), ("jump SELF again\n", None)):
                script.write_text(text + more)
                scene = dem_script.read(script)
                self.assertEqual(None if scene.positions is None else len(scene.positions), number)
                self.assertEqual(scene.diameters[0], 0.5)


class Packing(unittest.TestCase):
    def test_share_of_space_and_contacts(self) -> None:
        for style, per_cell, nearest, touching in (("sc", 1, 1.0, 6), ("fcc", 4, math.sqrt(0.5), 12)):
            points, sizes = lattice(style, 1.0), np.full(64 * per_cell, nearest)
            exact = per_cell * math.pi / 6 * nearest**3
            found = scene_packing.solid_fraction(points, sizes, 2.5, BOX)  # all sides narrower than two kernels
            self.assertAlmostEqual(found, exact, delta=0.01 * exact)
            self.assertEqual(scene_packing.contacts(points, sizes, BOX, (True, True, True)), touching)
            self.assertEqual(scene_packing.contacts(points, 0.9 * sizes, BOX, (True, True, True)), 0)

    def test_lone_particle_and_too_many_images(self) -> None:
        one = np.array([[2.0, 2, 2]])
        kernel = math.pi**1.5 * 0.8**3
        self.assertAlmostEqual(scene_packing.solid_fraction(one, np.array([1.0]), 0.8, BOX), math.pi / 6 / kernel)
        self.assertIsNone(scene_packing.solid_fraction(one, np.array([1.0]), 1e4, BOX))


if __name__ == "__main__":
    unittest.main()
