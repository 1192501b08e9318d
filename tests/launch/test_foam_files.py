"""OpenFOAM readers on a handmade mesh of two cubes, ascii and binary, plain and gzip."""

import gzip
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import facts, foam_file, foam_mesh
from tests.launch import handmade


class FoamFiles(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.case = Path(holder.name)

    def both(self):
        for binary in (False, True):
            case = self.case / ("binary" if binary else "ascii")
            handmade.write_mesh(case, binary)
            yield case, binary

    def test_geometry(self) -> None:
        for case, _ in self.both():
            mesh = foam_mesh.read_mesh(case)
            self.assertEqual(mesh.cells, 2)
            np.testing.assert_allclose(mesh.volumes(), [1, 1], rtol=1e-14)
            low, high = mesh.cell_bounds()
            np.testing.assert_array_equal(low, [[0, 0, 0], [1, 0, 0]])
            np.testing.assert_array_equal(high, [[1, 1, 1], [2, 1, 1]])
            area, centre = mesh.face_vectors()
            np.testing.assert_allclose(area[0], [1, 0, 0], atol=1e-15)
            np.testing.assert_allclose(centre[0], [1, 0.5, 0.5], atol=1e-15)
            self.assertEqual([(p.name, p.type, p.faces, p.start) for p in mesh.patches],
                             [("ends", "wall", 2, 1), ("sides", "empty", 4, 3), ("rest", "patch", 4, 7)])

    def test_facts(self) -> None:
        for case, _ in self.both():
            known = facts.mesh_facts(case)
            self.assertEqual((known.cells, known.flat, known.cyclic),
                             (2, (False, True, False), (False, False, False)))

    def test_fields(self) -> None:
        for case, binary in self.both():
            handmade.write_field(case / "1.5/p", [0.1, -2e-8], binary)
            handmade.write_field(case / "1.5/U", [(1.0, 2.0, 3.0), (4.0, 5.0, 6.0)], binary)
            np.testing.assert_array_equal(foam_file.read_field(case / "1.5/p", 2), [0.1, -2e-8])
            np.testing.assert_array_equal(foam_file.read_field(case / "1.5/U", 2), [[1, 2, 3], [4, 5, 6]])
            with self.assertRaises(foam_file.FoamFormatError):
                foam_file.read_field(case / "1.5/p", 3)
            (case / "0").mkdir()
            (case / "0.25").mkdir()
            self.assertEqual([t for t, _ in foam_mesh.times(case)], [0, 0.25, 1.5])

    def test_uniform_fields(self) -> None:
        path = self.case / "q"
        path.write_bytes(handmade.head("volScalarField", True) + b"internalField   uniform 3.5;\n")
        np.testing.assert_array_equal(foam_file.read_field(path, 3), [3.5] * 3)
        path.write_bytes(handmade.head("volVectorField", True) + b"internalField uniform (0 1 2);\n")
        np.testing.assert_array_equal(foam_file.read_field(path, 2), [[0, 1, 2]] * 2)

    def test_gzip(self) -> None:
        handmade.write_mesh(self.case, False)
        owner = self.case / "constant/polyMesh/owner"
        owner.with_name("owner.gz").write_bytes(gzip.compress(owner.read_bytes()))
        owner.unlink()
        np.testing.assert_array_equal(foam_mesh.read_mesh(self.case).owner, handmade.OWNER)

    def test_torn_list_is_named(self) -> None:
        handmade.write_mesh(self.case, False)
        owner = self.case / "constant/polyMesh/owner"
        owner.write_bytes(owner.read_bytes()[:-8])
        with self.assertRaises(foam_file.FoamFormatError):
            foam_mesh.read_mesh(self.case)


if __name__ == "__main__":
    unittest.main()
