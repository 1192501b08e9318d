"""`slidewave submit` with a real one-node Slurm on loopback (slurm_node.py): a job that finishes,
and jobs that are warned on demand and by their time limit. Skipped, with the reason, where Slurm
cannot be started. Shell scripts stand in for the two programs."""

import os
import re
import sys
import tempfile
import time
import unittest
from pathlib import Path
from unittest import mock

from launch import results
from tests.launch.scratch import ScratchCase
from tests.launch.slurm_node import SlurmNode

HISTORY = "printf 'window,time_s,sphere_vz_m_s\\n0,0,0\\n1,1,-1\\n' >\"$1/history.csv\"\n"
WAIT = ("trap 'echo asked >> \"$1/asked\"; exit 0' USR1; touch \"$1/up\"\n"
        "i=0; while [ $i -lt 2000 ]; do sleep 0.1; i=$((i+1)); done; exit 3")


class Slurm(ScratchCase):
    @classmethod
    def setUpClass(cls) -> None:
        holder = tempfile.TemporaryDirectory(prefix="slidewave-slurm-")
        cls.addClassCleanup(holder.cleanup)
        Path(holder.name).chmod(0o755)
        cls.node = SlurmNode(Path(holder.name))
        cls.addClassCleanup(cls.node.stop)
        reason = cls.node.start()
        if reason:
            print(f"skipped: no Slurm here ({reason})", file=sys.stderr)
            raise unittest.SkipTest(reason)

    def submit(self, fluid: str, dem: str, *more: str) -> str:
        """Number of the job; stand-ins for the programs are scripts with these texts."""
        (self.place / "bin").mkdir()
        for name, text in (("slidewave_uniform", fluid), ("slidewave_dem", HISTORY + dem)):
            (self.place / "bin" / name).write_text(f"#!/bin/sh\n{text}\n")
            (self.place / "bin" / name).chmod(0o755)
        self.out = self.place / "run"
        environment = {"SLIDEWAVE_BUILD": str(self.place), "SLURM_CONF": self.node.environment["SLURM_CONF"]}
        with mock.patch.dict(os.environ, environment):
            status, text, err = self.slidewave("submit", self.case, "--variant", "uniform", "--out", self.out,
                                               "--ranks-fluid", "1", "--ranks-dem", "1", *more)
        self.assertEqual(status, 0, text + err)
        return re.search(r"submitted as job (\d+)", text).group(1)

    def ended(self, job: str, patience_s: float) -> tuple[str, str]:
        """Exit code as Slurm shows it ("0:0") and the log of a job that left the queue."""
        end = time.monotonic() + patience_s
        while "JobState=COMPLETING" in (shown := self.node.ask("scontrol", "show", "job", job)) or (
                "JobState=RUNNING" in shown or "JobState=PENDING" in shown):
            self.assertLess(time.monotonic(), end, shown)
            time.sleep(0.2)
        return re.search(r"ExitCode=(\S+)", shown).group(1), (self.out / f"job-{job}.log").read_text()

    def await_up(self) -> None:
        end = time.monotonic() + 60
        while not (self.out / "up").exists():
            self.assertLess(time.monotonic(), end, "the programs did not start")
            time.sleep(0.1)

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "two ranks need two cores")
    def test_job_ends_well(self) -> None:
        code, log = self.ended(self.submit("exit 0", "exit 0"), 60)
        self.assertEqual(code, "0:0", log)
        self.assertTrue((self.out / "report.html").is_file(), log)

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "two ranks need two cores")
    def test_failure_is_the_job_s_status(self) -> None:
        self.assertEqual(self.ended(self.submit("exit 1", "exit 1"), 60)[0], "1:0")

    @unittest.skipIf(len(os.sched_getaffinity(0)) < 2, "two ranks need two cores")
    def test_asked_to_leave(self) -> None:
        job = self.submit(WAIT, WAIT)
        self.await_up()
        time.sleep(0.5)
        self.node.ask("scancel", "--batch", "--signal=USR1", job)
        self.left(job, 60)

    @unittest.skipUnless("SLIDEWAVE_SLOW" in os.environ, "a minute long")
    def test_time_limit(self) -> None:
        self.left(self.submit(WAIT, WAIT, "--time", "0:02:00", "--warning", "60"), 110)

    @unittest.skipUnless("SLIDEWAVE_SLOW" in os.environ, "some minutes long")
    def test_goes_on_after_the_time_limit(self) -> None:
        """Both real programs: the limit, a checkpoint, another job, the answer of an uninterrupted run. Slurm
        asks a job to leave within its first minute here: as long a run as takes this machine 90 s."""
        words = ["--variant", "uniform", "--set", "output.interval=0.5", "--force", "--ranks-fluid", "1", "--ranks-dem",
                 "1"]
        end_s = round(1.5 * 90 / self.finished("short", *words, "--set", "case.end_time=1.5")["wall_s"], 1)
        words += ["--set", f"case.end_time={end_s}"]
        self.finished("whole", *words)
        self.out = self.place / "run"
        with mock.patch.dict(os.environ, {"SLURM_CONF": self.node.environment["SLURM_CONF"]}):
            status, text, err = self.slidewave("submit", self.case, "--out", self.out, *words, "--time", "0:02:00",
                                               "--warning", "60")
        self.assertEqual(status, 0, text + err)
        job = re.search(r"submitted as job (\d+)", text).group(1)
        jobs = 1
        while jobs < 9:
            code, log = self.ended(job, 200)
            self.assertEqual(code, "0:0", log)
            found = re.search(r"goes on as job (\d+)", log)
            if not found:
                break
            job, jobs = found.group(1), jobs + 1
        self.assertGreater(jobs, 1, "the run was over before its limit: make it longer")
        self.assertIn("going on after window", log)
        self.assertEqual((self.out / "history.csv").read_text(), (self.place / "whole/history.csv").read_text())

    def finished(self, name: str, *words: str) -> dict:
        """Summary of a run without Slurm, whether it meets its targets or not."""
        out = self.place / name
        self.slidewave("run", self.case, "--out", out, *words)
        summary = results.read_summary(out)
        self.assertEqual(summary.get("status"), "completed")
        return summary

    def left(self, job: str, patience_s: float) -> None:
        code, log = self.ended(job, patience_s)
        self.assertEqual(code, "0:0", log)
        self.assertIn("asked to stop", log)
        self.assertEqual((self.out / "asked").read_text(), "asked\nasked\n")


if __name__ == "__main__":
    unittest.main()
