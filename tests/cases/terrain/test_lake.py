"""The lake at rest on quick's mesh, with the case's dictionaries and OpenFOAM's own interFoam.

VAJONT's bound is for 60 s (slow tests run that); a quarter of a minute shows the rise already.
"""

import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from launch import case as cases
from launch import parameters, places, verification
from launch.terrain import files, mesh, section_of

DURATION = float(os.environ.get("SLIDEWAVE_LAKE_SECONDS", "6"))  # 60 for the whole test


def read_field(path, components):
    """Internal field of a binary OpenFOAM field file."""
    data = path.read_bytes()
    start = re.search(rb"internalField\s+nonuniform List<\w+>\s*(\d+)\s*\(", data)
    count = int(start.group(1))
    return np.frombuffer(data, count=count * components, offset=start.end()).reshape(count, components)


class LakeAtRest(unittest.TestCase):
    def still(self, name):
        clock = time.monotonic()
        with tempfile.TemporaryDirectory() as place:
            run = Path(place) / "fluid"
            case = cases.load(f"vajont_{name}", "slide_held",
                              [f"case.end_time={DURATION}", f"output.interval={DURATION}"])
            shutil.copytree(case.directory / "fluid", run)
            (Path(place) / "dem").mkdir()
            parameters.write(case, run, Path(place) / "dem")
            section = section_of(case)
            columns = mesh.make_columns(section, case.get("geometry.cell_size"))
            made = mesh.make_mesh(columns, 2 * case.parameters["d_max"])
            files.write_poly_mesh(made, run / "constant" / "polyMesh")
            start = files.lake_fraction(made, section.lake_level)
            files.set_internal_field(run / "0" / "alpha.water", start)
            done = subprocess.run(["interFoam", "-case", str(run)], capture_output=True, text=True,
                                  env=places.openfoam_environment(), timeout=60 + 20 * DURATION,
                                  check=False)
            self.assertEqual(done.returncode, 0, done.stdout[-1000:] + done.stderr[-1000:])
            last = run / f"{DURATION:g}"
            water = read_field(last / "alpha.water", 1)[:, 0]
            speed = np.linalg.norm(read_field(last / "U", 3), axis=1)
        volume = np.array([mesh.polygon_area(o) for o in made.outline])
        weight = water * volume
        mean = (weight * speed).sum() / weight.sum()
        verification.record(f"vajont_{name} lake at rest, interFoam, {DURATION:g} s",
                            "mean speed in the water [m/s]", mean, 0, 0.05,
                            time.monotonic() - clock)
        self.assertLess(mean, 0.05)
        self.assertAlmostEqual(weight.sum() / (start * volume).sum(), 1, delta=1e-6)
        # Level of each wide-open column: what its water reaches, against the lake level.
        height = np.bincount(made.column, weight) / np.diff(columns.x)
        at_start = np.bincount(made.column, start * volume) / np.diff(columns.x)
        drift = np.abs(height - at_start)[at_start > 3 * case.get("geometry.cell_size")]
        self.assertLess(drift.max(), 0.1 * case.get("geometry.cell_size"))

    def test_east(self):
        self.still("east")

    def test_west(self):
        self.still("west")


if __name__ == "__main__":
    unittest.main()
