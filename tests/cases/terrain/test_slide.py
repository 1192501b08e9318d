"""Preparation of a slide with few, large grains: porosity, rest, cache, refusals."""

import os
import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from launch import case as cases
from launch import parameters
from launch.errors import InputError
from launch.terrain import prepare, section_of, slab_width

COARSE = ["parameters.d_min=18", "parameters.d_max=24", "geometry.cell_size=24",
          "parameters.dem_dt=5e-3"]


class Slide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.place = Path(holder.name)
        patched = mock.patch.dict(os.environ, {"SLIDEWAVE_CACHE": str(cls.place / "cache")})
        patched.start()
        cls.addClassCleanup(patched.stop)
        cls.first = cls.prepare("first")

    @classmethod
    def prepare(cls, name, settings=(), variant="dry"):
        case = cases.load("vajont_west", variant, [*COARSE, *settings])
        dem = cls.place / name / "dem"
        dem.mkdir(parents=True)
        for path in (case.directory / "dem").iterdir():
            (dem / path.name).write_text(path.read_text())
        parameters.write(case, None, dem)
        said = []
        prepare(case, cls.place / name, said.append)
        return case, dem, said

    def spheres(self, dem):
        rows = np.array((dem / "slide.data").read_text().split("Atoms\n")[1].split(), dtype=float)
        return rows.reshape(-1, 7)

    def test_porosity_and_place(self):
        case, dem, said = self.first
        rows = self.spheres(dem)
        section = section_of(case)
        width = slab_width(case)
        solid = np.pi / 6 * (rows[:, 2] ** 3).sum() / (115470 * width)
        self.assertTrue(0.37 <= 1 - solid <= 0.47, 1 - solid)  # a rim of coarse grains is missing
        self.assertTrue(np.all(rows[:, 6] > section.height(rows[:, 4])))
        self.assertLess((rows[:, 6] - section.ground_height(rows[:, 4])).max(), 12)
        self.assertLess(rows[:, 4].max(), section.toe[0] - 10)
        self.assertTrue(np.all((rows[:, 5] >= 0) & (rows[:, 5] <= width)))
        corners = re.findall(r"vertex \S+ (\S+) \S+", (dem / "wall.stl").read_text())
        np.testing.assert_allclose(np.unique(np.array(corners, dtype=float)), [0, width], rtol=1e-9)

    def test_came_to_rest(self):
        kept = next((self.place / "cache").glob("slide-*"))
        dump = np.loadtxt(kept / "seated.dump", skiprows=9)
        mass = dump[:, 7] ** 3
        speed = np.linalg.norm(dump[:, 4:7], axis=1)
        self.assertLess((mass * speed).sum() / mass.sum(), 0.3)
        self.assertLess(speed.max(), 5)

    def test_second_time_comes_from_the_cache(self):
        _, dem, said = self.prepare("second", ["parameters.basal_angle=14"])
        self.assertIn("from the cache", said[-1])
        self.assertEqual((dem / "slide.data").read_text(),
                         (self.first[1] / "slide.data").read_text())
        self.assertIn("prepared", self.first[2][-1])

    def test_box_meets_at_split_x(self):
        case, dem, _ = self.first
        line = next(l for l in (dem / "slide.data").read_text().splitlines() if "xlo" in l)
        low, high = map(float, line.split()[:2])
        self.assertAlmostEqual(0.5 * (low + high), case.get("geometry.split_x"))
        section = section_of(case)
        self.assertLess(low, section.uphill_end)
        self.assertGreater(high, section.bank_end)

    def test_bad_geometry_is_refused(self):
        for setting, key in (("geometry.cell_size=-1", "cell_size"),
                             ("geometry.cellsize=5", "cellsize"),
                             ("geometry.slab_diameters=1", "slab_diameters"),
                             ("geometry.profile=nowhere.toml", "profile"),
                             ("parameters.d_min=30", "d_min")):
            with self.assertRaises(InputError) as caught:
                self.prepare(f"bad-{key}", [setting])
            self.assertIn(key, str(caught.exception))


if __name__ == "__main__":
    unittest.main()
