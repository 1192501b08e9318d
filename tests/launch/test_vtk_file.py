"""The particle reader on handmade files, binary and ascii, and the series file."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import vtk_file
from tests.launch import handmade

ROWS = [(0.0, 0.5, 1.0, 7, 0.25, 0), (1.5, -0.5, 2.0, 3, 0.5, 4), (9.0, 0.0, -1e-9, 1, 0.125, 2)]


class Vtk(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)

    def test_points_and_data(self) -> None:
        for binary in (True, False):
            path = self.place / f"p{binary}.vtk"
            handmade.write_particles(path, ROWS, binary)
            points = vtk_file.read_points(path)
            np.testing.assert_array_equal(points.positions, [r[:3] for r in ROWS])
            np.testing.assert_array_equal(points.data["id"], [7, 3, 1])
            np.testing.assert_array_equal(points.data["radius"], [0.25, 0.5, 0.125])
            np.testing.assert_array_equal(points.data["layer"], [0, 4, 2])
            self.assertEqual(points.data["velocity"].shape, (3, 3))

    def test_no_particles(self) -> None:
        handmade.write_particles(self.place / "none.vtk", [])
        self.assertEqual(len(vtk_file.read_points(self.place / "none.vtk").positions), 0)

    def test_torn_and_foreign_files(self) -> None:
        path = self.place / "p.vtk"
        handmade.write_particles(path, ROWS)
        path.write_bytes(path.read_bytes()[:120])
        with self.assertRaises(vtk_file.VtkFormatError):
            vtk_file.read_points(path)
        path.write_text("solid ascii\n")
        with self.assertRaises(vtk_file.VtkFormatError):
            vtk_file.read_points(path)

    def test_series(self) -> None:
        handmade.write_particles(self.place / "b.vtk", ROWS)
        (self.place / "particles.vtk.series").write_text(
            '{"file-series-version": "1.0", "files": [{"name": "gone.vtk", "time": 0.0},'
            ' {"name": "b.vtk", "time": 2.5}]}')
        self.assertEqual(vtk_file.read_series(self.place / "particles.vtk.series"),
                         [(2.5, self.place / "b.vtk")])
        self.assertEqual(vtk_file.read_series(self.place / "nowhere"), [])


if __name__ == "__main__":
    unittest.main()
