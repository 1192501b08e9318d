"""slidewave_pack: overlaps by brute force over all pairs and images, solid fraction, all inside."""

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch.places import program

BASE = "0 100\n60 40\n100 30\n140 30\n"
GROUND = "0 100\n50 95\n110 80\n140 30\n"
WIDTH = 12.0
LEAST, MOST = 3.0, 6.0


class Pack(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)
        (self.place / "base.txt").write_text(BASE)
        (self.place / "ground.txt").write_text(GROUND)

    def run_pack(self, command, **options):
        words = [str(program("slidewave_pack")), command, "--base", "base.txt", "--top", "ground.txt"]
        options = {"width": WIDTH, "out": "out.data"} | options
        for name, value in options.items():
            words += [f"--{name}", str(value)]
        return subprocess.run(words, cwd=self.place, capture_output=True, text=True, timeout=60,
                              check=False)

    def fill(self, **options):
        done = self.run_pack("fill", **({"least": LEAST, "most": MOST} | options))
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def spheres(self):
        """Columns x y z diameter density of the data file."""
        text = (self.place / "out.data").read_text()
        rows = np.array(text.split("Atoms\n")[1].split(), dtype=float).reshape(-1, 7)
        np.testing.assert_array_equal(rows[:, 0], np.arange(1, len(rows) + 1))
        return rows[:, [4, 5, 6, 2, 3]]

    def largest_overlap(self, s):
        reach = 0.5 * (s[:, None, 3] + s[None, :, 3])
        smaller = np.minimum(s[:, None, 3], s[None, :, 3])
        worst = 0.0
        for image in (-WIDTH, 0, WIDTH):
            d = s[:, None, :3] - s[None, :, :3]
            d[:, :, 1] += image
            depth = (reach - np.sqrt((d**2).sum(axis=2))) / smaller
            np.fill_diagonal(depth, -1)
            worst = max(worst, depth.max())
        return worst

    def test_overlap_is_below_the_limit_and_reported(self):
        facts = self.fill(limit=0.015)
        s = self.spheres()
        self.assertEqual(facts["particles"], len(s))
        self.assertGreater(len(s), 200)
        found = self.largest_overlap(s)
        self.assertLess(found, 0.0151)
        self.assertLessEqual(found, facts["largest_overlap"] * 1.01)

    def test_without_passes_spheres_do_overlap(self):
        self.fill(passes=0, limit=10)
        self.assertGreater(self.largest_overlap(self.spheres()), 0.3)

    def test_solid_fraction_and_diameters(self):
        facts = self.fill(margin=0, passes=0, limit=10)
        s = self.spheres()
        x = np.linspace(0, 140, 140001)
        base = np.interp(x, *np.loadtxt(self.place / "base.txt").T)
        ground = np.interp(x, *np.loadtxt(self.place / "ground.txt").T)
        room = np.trapezoid(ground - base, x) if hasattr(np, "trapezoid") else np.trapz(ground - base, x)
        solid = np.pi / 6 * (s[:, 3] ** 3).sum() / (room * WIDTH)
        self.assertAlmostEqual(solid, 0.59, delta=0.59 * 113 / (room * WIDTH * 0.59) + 1e-3)
        self.assertAlmostEqual(facts["solid_fraction"], solid, delta=1e-4)
        self.assertTrue(np.all((s[:, 3] >= LEAST) & (s[:, 3] <= MOST)))
        self.assertAlmostEqual(s[:, 3].mean(), 4.5, delta=0.2)
        np.testing.assert_array_equal(s[:, 4], 2650)

    def test_all_are_inside(self):
        self.fill()
        s = self.spheres()
        base = np.loadtxt(self.place / "base.txt")
        dense = np.column_stack([np.linspace(0, 140, 28001),
                                 np.interp(np.linspace(0, 140, 28001), *base.T)])
        distance = np.sqrt(((s[:, None, [0, 2]] - dense[None]) ** 2).sum(axis=2)).min(axis=1)
        self.assertTrue(np.all(s[:, 2] > np.interp(s[:, 0], *base.T)))
        self.assertGreater((distance - 0.5 * s[:, 3]).min(), -0.021 * MOST)
        self.assertTrue(np.all((s[:, 1] >= 0) & (s[:, 1] < WIDTH)))
        self.assertTrue(np.all(s[:, 0] + 0.5 * s[:, 3] <= 140 + 1e-9))

    def test_same_seed_same_spheres(self):
        self.fill(seed=7)
        first = self.spheres()
        self.fill(seed=7)
        np.testing.assert_array_equal(first, self.spheres())
        self.fill(seed=8)
        self.assertFalse(np.array_equal(first[:5], self.spheres()[:5]))

    def test_trim_keeps_what_lies_below_the_ground_and_before_the_toe(self):
        rows = [(30, 1, 80, 2), (30, 1, 110, 2), (130, 1, 40, 2), (100, 1, 50, 1)]
        head = "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS\n0 1\n0 1\n0 1\n"
        lines = "\n".join(f"{9 - i} {x} {y} {z} {r}" for i, (x, y, z, r) in enumerate(rows))
        (self.place / "last.dump").write_text(
            head + "ITEM: ATOMS id x y z radius \n" + lines.replace("110", "90") + "\n"
            + head + "ITEM: ATOMS id x y z radius \n" + lines + "\n")
        done = self.run_pack("trim", dump="last.dump", gap=15)
        self.assertEqual(done.returncode, 0, done.stderr)
        np.testing.assert_array_equal(self.spheres()[:, 0], [30, 100])
        np.testing.assert_array_equal(self.spheres()[:, 3], [4, 2])
        done = self.run_pack("convert", dump="last.dump")
        self.assertEqual(len(self.spheres()), 4)

    def test_bad_input_is_refused(self):
        for options, reason in (
            ({"least": 5, "most": 4}, "--least and --most"),
            ({"least": 3, "most": 13}, "--width must be above --most"),
            ({"least": 3, "most": 6, "colour": 1}, "unknown option --colour"),
            ({"least": "three", "most": 6}, ""),
        ):
            done = self.run_pack("fill", **options)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(reason, done.stderr)
        (self.place / "base.txt").unlink()
        done = self.run_pack("fill", least=3, most=6)
        self.assertEqual(done.returncode, 1)
        self.assertIn("base.txt: cannot be read", done.stderr)


if __name__ == "__main__":
    unittest.main()
