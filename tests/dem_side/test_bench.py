"""bench dem on a bed of 300 spheres: it settles, both laws run, and their paths agree."""

import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import bench_dem, bench_scenes

COUNT = 300


class Bench(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)

    def test_bed_comes_to_rest_in_its_box_and_both_laws_run_it(self) -> None:
        bed = bench_dem.settled_bed(COUNT)
        self.addCleanup(bed.unlink)
        shutil.copyfile(bed, self.place / "bed.data")
        bench_scenes.write_bed(self.place, COUNT)
        speeds = bench_dem._speeds(self.place, "bed", COUNT, 2000, repeats=1)
        self.assertGreater(speeds["ratio_bed"], 0.5)
        self.assertLess(bench_dem._two_ranks(self.place, 1, 100)["two_rank_balance"], 1.2, "cut along the height")
        bench_dem._run(self.place, "bed.in", {"law": "own", "steps": 2000, "dumping": 1})
        end = bench_scenes.last_snapshot(self.place / "own.dump")
        rows = np.array(bed.read_text().split("Atoms")[1].split(), dtype=float).reshape(-1, 7)
        self.assertEqual(len(end), COUNT)
        self.assertLess(np.abs(end[:, 1:4] - rows[:, 4:7]).max(), 0.5, "the bed moved")
        self.assertGreater(end[:, 3].min(), 0.8, "below the floor")

    def test_laws_agree_where_they_coincide(self) -> None:
        bed = bench_dem.settled_bed(COUNT)
        self.addCleanup(bed.unlink)
        shutil.copyfile(bed, self.place / "bed.data")
        bench_scenes.write_bed(self.place, COUNT)
        self.assertLess(bench_dem._difference(self.place), 1e-9)
        kept = bench_dem._difference(self.place, factor=1)
        self.assertGreater(kept, 1e-9, "the packaged law forgets by itself: compare with its default")


if __name__ == "__main__":
    unittest.main()
