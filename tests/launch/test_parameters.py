"""Values reach both sides' parameter files unchanged."""

import re
import unittest

from launch import case as cases
from launch import dem_script, parameters
from tests.launch.scratch import ScratchCase


class Parameters(ScratchCase):
    def setUp(self) -> None:
        super().setUp()
        self.loaded = cases.load(str(self.case), None, ["parameters.fluid_viscosity=0.12345678901234567",
                                                        "physics.gravity=[1.5, 0, -9.25]"])

    def test_fluid_file_reads_back(self) -> None:
        text = parameters.fluid_text(self.loaded)
        found = dict(re.findall(r"^(\w+) ([^;()]+);$", text, flags=re.M))
        expected = dict(self.loaded.parameters, end_time=0.1, window=5e-4, output_interval=0.02)
        self.assertEqual({k: float(v) for k, v in found.items()}, expected)
        self.assertIn("gravity (1.5 0 -9.25);", text)

    def test_dem_file_reads_back_through_the_script_reader(self) -> None:
        file = self.place / "parameters"
        file.write_text(parameters.dem_text(self.loaded))
        script = self.place / "in.show"
        script.write_text("show ${fluid_viscosity} ${gravity_x} ${gravity_z} ${window} ${end_time}\n")
        words = dem_script.read(script, file).commands[-1]
        self.assertEqual([float(w) for w in words[1:]], [0.12345678901234567, 1.5, -9.25, 5e-4, 0.1])

    def test_texts_are_quoted_where_needed(self) -> None:
        self.loaded.put("parameters.scheme", "vanLeer")
        self.loaded.put("parameters.note", "two words")
        self.assertIn("scheme vanLeer;", parameters.fluid_text(self.loaded))
        self.assertIn('note "two words";', parameters.fluid_text(self.loaded))
        self.assertIn('variable note index "two words"', parameters.dem_text(self.loaded))


if __name__ == "__main__":
    unittest.main()
