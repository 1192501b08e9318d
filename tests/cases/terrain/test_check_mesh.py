"""OpenFOAM's own checkMesh accepts the meshes of quick and standard."""

import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from launch import places
from launch.terrain import files, mesh

from .scene import CELL, D_MAX, FIGURES, section

CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeInterval 1;
"""


class CheckMesh(unittest.TestCase):
    def check(self, name, cell, width):
        with tempfile.TemporaryDirectory() as place:
            case = Path(place)
            (case / "system").mkdir()
            (case / "system" / "controlDict").write_text(CONTROL)
            for other in ("fvSchemes", "fvSolution"):
                shutil.copy(places.ROOT / "cases/vajont_east/fluid/system" / other, case / "system")
            made = mesh.make_mesh(mesh.make_columns(section(name), cell), width)
            files.write_poly_mesh(made, case / "constant" / "polyMesh")
            done = subprocess.run(["checkMesh", "-case", place], capture_output=True, text=True,
                                  env=places.openfoam_environment(), timeout=60, check=False)
            self.assertIn("Mesh OK.", done.stdout, done.stdout[-800:] + done.stderr[-800:])

    def test_quick(self):
        for name in FIGURES:
            self.check(name, CELL, 2 * D_MAX)

    def test_standard(self):
        self.check("east", 5.0, D_MAX)


if __name__ == "__main__":
    unittest.main()
