"""Restarts with both real engines: from a checkpoint, and after kill -9 at random moments, a run comes
to the end of the run that was left alone, every row of history.csv and every bit of the state (fields,
old times, particles, contacts, ledger) the same. SLIDEWAVE_KILLS: how many runs to kill (default 1)."""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from launch import results
from launch.places import ROOT

SPHERE = ("settling_sphere", "--set", "case.end_time=0.06", "--set", "output.interval=0.01",
          "--set", "checkpoint.windows=40", "--set", "checkpoint.keep=99")
SLIDE = ("vajont_east", "--set", "case.end_time=0.8", "--set", "output.interval=0.4",
         "--set", "checkpoint.windows=20", "--set", "checkpoint.keep=999")
# Large grains and cells, to 16 s: the slide strikes the lake from 4 s on, its wave is highest after 12 s.
IMPACT = ("vajont_east", "--set", "case.end_time=16", "--set", "output.interval=2", "--set", "coupling.window=0.04",
          "--set", "checkpoint.windows=20", "--set", "checkpoint.keep=999", "--set", "geometry.cell_size=24",
          "--set", "parameters.d_min=12", "--set", "parameters.d_max=20", "--set", "parameters.coarse_grain=6",
          "--set", "parameters.dem_dt=5e-3")


def slidewave(*words):
    return subprocess.Popen([sys.executable, "-m", "launch", *map(str, words)], cwd=ROOT,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def solvers(directory):
    """Process ids of the two programs that run in a directory."""
    found = []
    for entry in Path("/proc").glob("[0-9]*"):
        try:
            words = (entry / "cmdline").read_bytes().decode().split("\0")
        except OSError:
            continue
        if Path(words[0]).name in ("slidewave_foam", "slidewave_dem") and str(directory) in words:
            found.append(int(entry.name))
    return sorted(found)


class Restart(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name).resolve()

    def run_case(self, case, name, *more):
        """Runs to the end; gives the directory and the output."""
        out = self.place / name
        job = slidewave("run", *case, "--out", out, *more)
        text = job.communicate(timeout=600)[0]
        self.assertEqual(results.read_summary(out).get("status"), "completed", text)
        return out, text

    def whole(self, case, *more):
        out, _ = self.run_case(case, "whole", *more)
        self.windows = sorted(p.name for p in (out / "checkpoints").iterdir())
        self.assertGreater(len(self.windows), 1)
        return out

    def same(self, one, other):
        self.assertEqual((one / "history.csv").read_text(), (other / "history.csv").read_text())
        for window in self.windows:
            pieces = [json.loads((d / "checkpoints" / window / "manifest.json").read_text())["pieces"]
                      for d in (one, other)]
            self.assertEqual(pieces[0], pieces[1], window)

    def again(self, whole, case, *more):
        """A run that goes on from the first checkpoint."""
        out = self.place / "again"
        shutil.copytree(whole, out)
        for window in self.windows[1:]:
            shutil.rmtree(out / "checkpoints" / window)
        _, text = self.run_case(case, "again", "--restart", *more)
        self.assertIn(f"going on after window {int(self.windows[0])}", text)
        return out, text

    def test_settling_sphere(self):
        whole = self.whole(SPHERE, "--ranks-fluid", "2", "--ranks-dem", "2")
        self.same(whole, self.again(whole, SPHERE)[0])

    def test_concurrent(self):
        """The pressure gradient of the last window is in flight between the sides."""
        case = (*SPHERE, "--set", "coupling.scheme=concurrent")
        whole = self.whole(case, "--ranks-fluid", "2", "--ranks-dem", "1")
        self.assertEqual(results.read_summary(whole)["scheme"], "concurrent")
        out, _ = self.again(whole, case)
        self.same(whole, out)
        shutil.rmtree(out)
        out, _ = self.again(whole, case, "--ranks-fluid", 1, "--ranks-dem", 1)
        one, two = (results.read_history(place)["sphere_vz_m_s"] for place in (whole, out))
        self.assertLess(abs(one[1:] / two[1:] - 1).max(), 1e-6)

    def test_stiff(self):
        """Beds in the stiff regime: contacts and what the particles' sub-steps were are asked for by the
        first gather after a restart."""
        case = ("verification/held_bed", "--set", "case.end_time=0.04", "--set", "output.interval=0.04", "--set",
                "parameters.step_time=0.02", "--set", "checkpoint.windows=10", "--set", "checkpoint.keep=99", "--force")
        whole = self.whole(case, "--ranks-fluid", "1", "--ranks-dem", "2")
        self.assertIn('regime = "stiff"', (whole / "case.toml").read_text())
        self.same(whole, self.again(whole, case)[0])

    def test_forces(self):
        """Virtual mass, viscous force, lift and torque: what they remember of the last window goes on too, also
        at a free surface."""
        words = [w for key in ("virtual_mass=constant", "viscous_force=true", "lift=saffman_mei", "torque=rotational_drag")
                 for w in ("--set", f"models.{key}")]
        for name, case in (("sphere", SPHERE), ("slide", SLIDE)):
            with self.subTest(name):
                whole = self.whole((*case, *words, "--force"), "--ranks-fluid", "2", "--ranks-dem", "1")
                out, _ = self.again(whole, (*case, *words, "--force"))
                self.same(whole, out)
                shutil.rmtree(whole)
                shutil.rmtree(out)

    def test_slide(self):
        whole = self.whole(SLIDE, "--ranks-fluid", "2", "--ranks-dem", "2")
        rows = results.read_history(whole)
        self.assertGreater(abs(rows["ledger_z_kg_m_s"]).max(), 0, "the ledger is to hold something")
        out, _ = self.again(whole, SLIDE)
        self.same(whole, out)
        shutil.rmtree(out / "checkpoints")  # struck before the first: begins again
        _, text = self.run_case(SLIDE, "again", "--restart")
        self.assertIn("no complete checkpoint", text)
        self.same(whole, out)

    def test_other_ranks(self):
        whole = self.whole(SPHERE, "--ranks-fluid", "2", "--ranks-dem", "1")
        for fluid, dem in ((1, 2), (3, 1)):
            out, text = self.again(whole, SPHERE, "--ranks-fluid", fluid, "--ranks-dem", dem)
            self.assertIn("not bit for bit", text)
            one, two = results.read_history(whole), results.read_history(out)
            for name in ("sphere_vz_m_s", "sphere_z_m", "water_volume_m3"):
                self.assertLess(abs(one[name][1:] / two[name][1:] - 1).max(), 1e-6, name)
            self.assertLess(results.read_summary(out)["budgets"]["momentum_defect"], 1e-10)
            shutil.rmtree(out)

    def killed(self, case, *more):
        """Each run is killed once in its first half and once in its second, at moments that the seed chooses."""
        whole = self.whole(case, *more)
        rows = len(results.read_history(whole)["time_s"])
        for seed in range(int(os.environ.get("SLIDEWAVE_KILLS", "1"))):
            out = self.place / f"killed{seed}"
            chance, struck = random.Random(seed), []
            for attempt in range(9):
                job = slidewave("run", *case, "--out", out, *(["--restart"] if attempt else more))
                if attempt < 2:
                    row = chance.randrange(attempt * rows // 2 + 1, (attempt + 1) * rows // 2 - 3)
                    struck += self.strike(job, out, row, chance)
                text = job.communicate(timeout=600)[0]
                if results.read_summary(out).get("status") == "completed":
                    break
                self.assertNotEqual(job.returncode, 0)
            self.assertEqual(results.read_summary(out)["status"], "completed", text)
            self.assertGreater(len(struck), 0, "the run was over before it could be killed")
            self.same(whole, out)
            print(f"killed in windows {struck}, went on to the same end", flush=True)

    def strike(self, job, directory, row, chance):
        """kill -9 of one process, a moment after so many windows. Gives the window, nothing where it was too late."""
        history = directory / "history.csv"
        while job.poll() is None and not (history.is_file() and history.read_text().count("\n") > row):
            time.sleep(0.005)
        time.sleep(chance.uniform(0, 0.05))
        there = solvers(directory)
        if not there:
            return []
        os.kill(chance.choice(there), signal.SIGKILL)
        return [row]

    def test_killed_sphere(self):
        self.killed(SPHERE)

    def test_killed_slide(self):
        """Twice each, at moments anywhere in the run; the wave has run up before its end."""
        self.killed(IMPACT, "--ranks-fluid", "2", "--ranks-dem", "2")
        height = results.read_history(self.place / "whole")["wave_height_m"]
        self.assertGreater(height.max(), 50)

    def test_refusals(self):
        job = slidewave("run", *SPHERE, "--out", self.place / "none", "--restart")
        self.assertIn("holds no run", job.communicate(timeout=60)[0])
        self.assertEqual(job.returncode, 2)
        whole = self.whole(SPHERE)
        for words, told in ((("--set", "parameters.fluid_viscosity=0.3"), "parameters.fluid_viscosity"),
                            (("--overwrite",), "--overwrite")):
            job = slidewave("run", *SPHERE, "--out", whole, "--restart", *words)
            self.assertIn(told, job.communicate(timeout=60)[0])
            self.assertEqual(job.returncode, 2)
        _, text = self.run_case((*SPHERE, "--set", "case.end_time=0.07"), "whole", "--restart")
        self.assertAlmostEqual(results.read_history(whole)["time_s"][-1], 0.07)
        self.assertIn("case.toml has changed", text)


if __name__ == "__main__":
    unittest.main()
