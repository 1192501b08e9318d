"""The script reader on handmade scripts: variables, formulas, boxes, atoms, includes."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import dem_script
from launch.errors import InputError

DATA = """two atoms

2 atoms
1 atom types

0 10 xlo xhi
-1 1 ylo yhi
0 5 zlo zhi

Atoms

1 1 0.5 2650 1 0 2
2 1 0.75 2600 3 0.5 4
"""


class Script(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)

    def read(self, text: str) -> dem_script.DemScene:
        (self.place / "in.x").write_text(text)
        return dem_script.read(self.place / "in.x")

    def test_formulas(self) -> None:
        variables = {"a": "3", "b": "2e-1"}
        self.assertAlmostEqual(dem_script.evaluate("2*v_a^2 + sqrt(16)/v_b - PI", variables), 38 - np.pi)
        for bad in ("v_c + 1", "__import__('os')", "a.b", "1/0", "open(1)"):
            with self.assertRaises(ValueError):
                dem_script.evaluate(bad, variables)

    def test_region_box_and_single_atoms(self) -> None:
        scene = self.read("variable w index 4\nvariable half equal v_w/2\nboundary f p f # sides\n"
                          "region all block 0 10 -${half} & \n $(v_half) 0 5 units box\ncreate_box 1 all\n"
                          "create_atoms 1 single 1 0 2 units box\nset group all diameter 0.5 density 2650\n")
        self.assertEqual(scene.periodic, (False, True, False))
        np.testing.assert_array_equal(scene.box, [[0, -2, 0], [10, 2, 5]])
        np.testing.assert_array_equal(scene.positions, [[1, 0, 2]])
        np.testing.assert_array_equal(scene.diameters, [0.5])

    def test_data_file_through_an_include(self) -> None:
        (self.place / "atoms.data").write_text(DATA)
        (self.place / "in.more").write_text("variable file index atoms.data\nread_data ${file}\n")
        scene = self.read("boundary p p f\ninclude in.more\n")
        np.testing.assert_array_equal(scene.box, [[0, -1, 0], [10, 1, 5]])
        np.testing.assert_array_equal(scene.diameters, [0.5, 0.75])
        np.testing.assert_array_equal(scene.densities, [2650, 2600])
        np.testing.assert_array_equal(scene.positions, [[1, 0, 2], [3, 0.5, 4]])

    def test_missing_data_file_is_refused(self) -> None:
        with self.assertRaises(InputError):
            self.read("read_data nowhere.data\n")

    def test_broken_files_are_refused_with_their_name(self) -> None:
        for data, key in ((DATA.replace("0.75 2600", "0.75"), "Atoms"), (DATA.replace("2650", "heavy"), "Atoms"),
                          (DATA.replace("0 10 xlo", "0 1o xlo"), "xlo"), (b"2 atoms\n\xff\xfe", "byte 8")):
            (self.place / "atoms.data").write_bytes(data if isinstance(data, bytes) else data.encode())
            with self.assertRaises(InputError) as caught:
                self.read("read_data atoms.data\n")
            self.assertIn("atoms.data", caught.exception.file)
            self.assertIn(key, caught.exception.key)
        with self.assertRaisesRegex(InputError, "in.x: include: goes round"):
            self.read("include in.x\n")

    def test_lammps_stiffness(self) -> None:
        self.assertEqual(self.read("pair_style gran/hooke/history 1e5 8e4 60 60 0.5 1\n").stiffness_N_m, 1e5)

    def test_insertion_leaves_the_number_open(self) -> None:
        scene = self.read("fix ins all insert/pack seed 123457 distributiontemplate d\n")
        self.assertIsNone(scene.positions)
        self.assertTrue(scene.creates)
        self.assertFalse(self.read("boundary f f f\n").creates)

    def test_stiffness(self) -> None:
        scene = self.read("fix k all property/global kn peratomtypepair 2 1e5 2e5 2e5 3e6\n")
        self.assertEqual(scene.stiffness_N_m, 3e6)
        scene = self.read("fix k all property/global kn peratomtypepair 1 1e-3\n")
        self.assertEqual(scene.stiffness_N_m, 1e-3)
        self.assertEqual(self.read("pair_style gran model linear kn 3e9 ks 1e9\n").stiffness_N_m, 3e9)


if __name__ == "__main__":
    unittest.main()
