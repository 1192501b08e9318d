"""Dictionary values through $name and #eval, as the pre-flight check reads them."""

import tempfile
import unittest
from pathlib import Path

from launch import foam_dict

TEXT = """#include "$FOAM_CASE/parameters"
phases (water air);   // nu 7;
water { transportModel Newtonian; nu #eval{ $mu / ${rho} }; rho $rho; }
air { nu 1.48e-5; rho 1.225; }
/* sigma 9; */
sigma [1 0 -2 0 0 0 0] 0.07;
nu nu [0 2 -1 0 0 0 0] #eval{ 2^3 * $mu };
adjustTimeStep  no;
"""


class Dictionary(unittest.TestCase):
    def setUp(self) -> None:
        with tempfile.TemporaryDirectory() as place:
            path = Path(place) / "d"
            path.write_text(TEXT)
            self.text = foam_dict.expanded(path, {"mu": 0.003, "rho": 1500})

    def test_entries(self) -> None:
        self.assertEqual(foam_dict.entry(self.text, "phases"), "(water air)")
        self.assertEqual(foam_dict.entry(self.text, "adjustTimeStep"), "no")
        self.assertEqual(foam_dict.number(self.text, "sigma"), 0.07)
        self.assertAlmostEqual(foam_dict.number(self.text, "nu"), 0.024)
        self.assertIsNone(foam_dict.number(self.text, "phases"))
        self.assertIsNone(foam_dict.entry(self.text, "deltaT"))

    def test_blocks(self) -> None:
        water = foam_dict.block(self.text, "water")
        self.assertEqual(foam_dict.number(water, "nu"), 2e-6)
        self.assertEqual(foam_dict.number(water, "rho"), 1500)
        self.assertEqual(foam_dict.block(self.text, "oil"), "")

    def test_missing_file(self) -> None:
        self.assertEqual(foam_dict.expanded(Path("nowhere"), {}), "")


if __name__ == "__main__":
    unittest.main()
