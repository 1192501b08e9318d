"""The lake at rest with the slide held in place, both real engines: the water in the slide's pores
and the open lake stay where they are, budgets close.

The bound is for 60 s; SLIDEWAVE_LAKE_SECONDS=60 runs that, the default shows the rise already.
"""

import os
import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

from launch import case as cases
from launch import cli, results, verification
from launch.terrain import mesh, section_of

from .test_lake import read_field

DURATION = float(os.environ.get("SLIDEWAVE_LAKE_SECONDS", "2"))


class HeldSlide(unittest.TestCase):
    def test_east(self):
        clock = time.monotonic()
        with tempfile.TemporaryDirectory() as place:
            out = Path(place).resolve() / "run"
            # Nothing moves: one particle step a window will do, which the pre-flight check dislikes.
            settings = [f"case.end_time={DURATION}", f"output.interval={DURATION}",
                        "parameters.dem_dt=0.02"]
            cli.main(["run", "cases/vajont_east", "--variant", "slide_held", "--force", "--out",
                      str(out), "--ranks-fluid", "1", "--ranks-dem", "1",
                      *(word for s in settings for word in ("--set", s))])
            summary, history = results.read_summary(out), results.read_history(out)
            self.assertEqual(summary["status"], "completed", summary.get("reason"))
            last = out / "fluid" / f"{DURATION:g}"
            water = read_field(last / "alpha.water", 1)[:, 0]
            speed = np.linalg.norm(read_field(last / "U", 3), axis=1)
        case = cases.load("vajont_east", "slide_held")
        made = mesh.make_mesh(
            mesh.make_columns(section_of(case), case.get("geometry.cell_size")), 1.0)
        weight = water * np.array([mesh.polygon_area(o) for o in made.outline])
        mean = (weight * speed).sum() / weight.sum()
        verification.record(f"vajont_east lake at rest, slide held, {DURATION:g} s",
                            "mean speed in the water [m/s]", mean, 0, 0.05,
                            time.monotonic() - clock)
        self.assertLess(mean, 0.05)
        heights = history["wave_height_m"]
        self.assertLess(np.ptp(heights), 0.1 * case.get("geometry.cell_size"))
        self.assertEqual(history["slide_speed_m_s"].max(), 0)
        self.assertLess(np.abs(history["water_volume_defect"]).max(), 1e-6)
        self.assertLess(np.abs(history["solid_volume_defect"]).max(), 1e-12)
        self.assertLess(history["min_void_fraction"].min(), 0.45)  # the slide is there


if __name__ == "__main__":
    unittest.main()
