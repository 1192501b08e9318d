"""A rock surface as LAMMPS regions: the same height as the polyline, each bend's segments once."""

import re
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch.terrain import half_spaces

from .scene import FIGURES, section


class HalfSpaces(unittest.TestCase):
    def test_same_surface_as_the_section(self):
        for name in FIGURES:
            wall = section(name).wall
            x = np.linspace(wall[0, 0], wall[-1, 0], 4001)
            found = half_spaces.region(half_spaces.bends(wall)).height(x)
            np.testing.assert_allclose(found, section(name).height(x), rtol=0, atol=1e-9)

    def test_any_polyline(self):
        """Random zigzags, valleys in ridges and ridges in valleys."""
        draw = np.random.default_rng(5)
        for count in list(range(2, 14)) * 20:
            line = np.column_stack([np.cumsum(draw.uniform(1, 3, count)), np.cumsum(draw.uniform(-4, 4, count))])
            x = np.linspace(line[0, 0], line[-1, 0], 997)
            found = half_spaces.region(line).height(x)
            np.testing.assert_allclose(found, np.interp(x, *line.T), rtol=0, atol=1e-9)

    def test_commands_name_each_line_once(self):
        """Read back from the file: two half-spaces of one line would press a grain twice."""
        for name in FIGURES:
            with tempfile.TemporaryDirectory() as place:
                path = Path(place) / "wall.in"
                half_spaces.write(section(name).wall, path)
                text = path.read_text()
            planes = [tuple(map(float, words)) for words in re.findall(r"plane (\S+) 0 (\S+) (\S+) 0 (\S+)", text)]
            lines = {(round(-a / c, 9), round(z + a / c * x, 6)) for x, z, a, c in planes}
            self.assertEqual(len(lines), len(planes))
            slopes = np.diff(section(name).wall[:, 1]) / np.diff(section(name).wall[:, 0])
            self.assertEqual(len(planes), 1 + (np.abs(np.diff(slopes)) > 1e-9).sum())
            defined = re.findall(r"^region (\S+)", text, re.M)
            self.assertEqual(len(set(defined)), len(defined))
            self.assertEqual(defined[-1], "terrain")


if __name__ == "__main__":
    unittest.main()
