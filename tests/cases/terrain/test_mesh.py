"""The fluid mesh: every cell's size, its bottom against the STL wall, closed cells, the lake."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch.terrain import files, mesh

from .scene import CELL, D_MAX, FIGURES, LAKE, section

WIDTH = 2 * D_MAX


def area_vector(points):
    """Area vector of a polygon in space, as a sum over triangles from its first corner."""
    a, b = points[1:-1] - points[0], points[2:] - points[0]
    return 0.5 * np.cross(a, b).sum(axis=0)


class Meshes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = {}
        for name in FIGURES:
            s = section(name)
            columns = mesh.make_columns(s, CELL)
            cls.made[name] = (s, columns, mesh.make_mesh(columns, WIDTH))

    def test_quick_has_at_most_12000_cells(self):
        for _, columns, made in self.made.values():
            self.assertLessEqual(columns.cells, 12000)
            self.assertEqual(columns.cells, len(made.outline))

    def test_cell_heights_within_0_6_and_1_5_of_nominal(self):
        for s, _, _ in self.made.values():
            for size in (4.0, 5.0, 7.3, CELL, 11.0):
                columns = mesh.make_columns(s, size)
                lowest = columns.lowest_heights() / size
                self.assertGreaterEqual(lowest.min(), 0.6 - 1e-9)
                self.assertLessEqual(lowest.max(), 1.5 + 1e-9)
                above = np.diff(columns.z) / size
                self.assertTrue(np.all((above > 0.6) & (above < 1.5)))

    def test_mean_height_of_every_cell_from_its_area(self):
        for _, _, made in self.made.values():
            for outline in made.outline:
                width = np.ptp(outline[:, 0])
                height = mesh.polygon_area(outline) / width / CELL
                self.assertTrue(0.6 - 1e-9 <= height <= 1.5 + 1e-9, height)

    def test_a_level_is_exactly_the_lake(self):
        for _, columns, _ in self.made.values():
            self.assertEqual(columns.z[columns.lake], LAKE)

    def test_every_vertex_of_the_profile_is_a_node(self):
        for s, columns, _ in self.made.values():
            for x, z in s.wall:
                i = np.argmin(np.abs(columns.x - x))
                self.assertEqual((columns.x[i], columns.base[i]), (x, z))

    def test_top_leaves_the_room_asked_for(self):
        for s, columns, _ in self.made.values():
            x = 0.5 * (columns.x[1:] + columns.x[:-1])
            top = columns.z[columns.high]
            self.assertTrue(np.all(top >= LAKE + 350))
            self.assertTrue(np.all(top >= s.height(x) + 150))
            self.assertTrue(np.all(top >= s.ground_height(x) + 50))

    def test_cells_are_closed_and_fill_the_section(self):
        for s, columns, made in self.made.values():
            cells = len(made.outline)
            total, volume = np.zeros((cells, 3)), np.zeros(cells)
            for i, face in enumerate(made.faces):
                points = made.points[face]
                vector = area_vector(points)
                flux = np.dot(points.mean(axis=0), vector) / 3
                total[made.owner[i]] += vector
                volume[made.owner[i]] += flux
                if i < len(made.neighbour):
                    total[made.neighbour[i]] -= vector
                    volume[made.neighbour[i]] -= flux
            self.assertLess(np.abs(total).max(), 1e-8)
            self.assertGreater(volume.min(), 0)
            middle = 0.5 * (columns.base[1:] + columns.base[:-1])
            section_area = np.sum((columns.z[columns.high] - middle) * np.diff(columns.x))
            self.assertAlmostEqual(volume.sum() / WIDTH / section_area, 1, delta=1e-12)

    def test_patches_hold_all_outer_faces(self):
        for _, _, made in self.made.values():
            sizes = {name: count for name, _, count in made.patches}
            self.assertEqual(len(made.faces) - len(made.neighbour), sum(sizes.values()))
            self.assertEqual(sizes["front"], len(made.outline))
            start = len(made.neighbour)
            for name, _, count in made.patches:
                normals = np.array([area_vector(made.points[f])
                                    for f in made.faces[start:start + count]])
                start += count
                if name == "terrain":
                    self.assertTrue(np.all(normals[:, 2] < 0))
                if name == "atmosphere":
                    self.assertTrue(np.all((normals[:, 2] > 0) | (np.abs(normals[:, 0]) > 0)))

    def test_water_is_what_lies_below_the_lake_level(self):
        for name, (s, _, made) in self.made.items():
            share = files.lake_fraction(made, LAKE)
            areas = np.array([mesh.polygon_area(o) for o in made.outline])
            x = np.arange(s.wall[0, 0], s.bank_end, 0.01) + 0.005
            expected = np.clip(LAKE - s.height(x), 0, None).sum() * 0.01
            self.assertAlmostEqual((share * areas).sum() / expected, 1, delta=1e-5)
            pores = np.clip(np.minimum(s.ground_height(x), LAKE) - s.height(x), 0, None)
            lake = (share * areas).sum() - pores.sum() * 0.01
            self.assertAlmostEqual(lake, FIGURES[name].water_area, delta=6)
            # Wedges at the shores: no cell begins half full.
            partly = share[(share > 1e-9) & (share < 1 - 1e-9)]
            self.assertTrue(np.all((partly < 5e-3) | (partly > 0.995)), partly)


class Wall(unittest.TestCase):
    def test_stl_equals_the_bottom_of_the_mesh(self):
        for name in FIGURES:
            s = section(name)
            columns = mesh.make_columns(s, CELL)
            with tempfile.TemporaryDirectory() as place:
                path = Path(place) / "wall.stl"
                files.write_wall_stl(s, path, -5, 20, longest=30)
                text = path.read_text()
            corners = np.array(re.findall(r"vertex (\S+) (\S+) (\S+)", text), dtype=float)
            normals = np.array(re.findall(r"facet normal (\S+) (\S+) (\S+)", text), dtype=float)
            self.assertEqual(len(corners), 3 * len(normals))
            self.assertTrue(np.all(normals[:, 2] > 0))
            line = np.unique(corners[:, [0, 2]], axis=0)
            bottom = np.interp(columns.x, line[:, 0], line[:, 1])
            np.testing.assert_allclose(bottom, columns.base, atol=1e-8)
            triangles = corners.reshape(-1, 3, 3)
            area = np.array([area_vector(t)[2] for t in triangles]).sum()
            self.assertAlmostEqual(area, 25 * (s.bank_end - s.wall[0, 0]), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
