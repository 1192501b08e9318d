"""Running points as commands: what a failing, a refused and a stopped run leave, and the time left."""

import json
import os
import signal
import subprocess
import time
import unittest

from launch import case as cases
from launch import results
from launch.places import ROOT
from launch.study_points import Point
from launch.study_runner import CommandRunner, Job, failure
from launch.study_schedule import Pace, duration
from tests.launch.scratch import ScratchCase

HISTORY = "printf 'window,time_s,sphere_vz_m_s\\n0,0,0\\n1,0.1,-0.0133\\n' > \"$1/history.csv\"\n"
WAIT = "trap 'exit 0' USR1; i=0; while [ $i -lt 300 ]; do sleep 0.1; i=$((i+1)); done"


class Schedule(ScratchCase):
    def programs(self, dem: str) -> None:
        """Shell scripts in place of the programs."""
        (self.place / "bin").mkdir(exist_ok=True)
        for name, text in (("slidewave_foam", "exit 0"), ("slidewave_dem", HISTORY + dem)):
            path = self.place / "bin" / name
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)
        previous = os.environ.get("SLIDEWAVE_BUILD", "")
        os.environ["SLIDEWAVE_BUILD"] = str(self.place)
        self.addCleanup(os.environ.__setitem__, "SLIDEWAVE_BUILD", previous)

    def test_runs_the_command_with_the_settings_of_the_point(self) -> None:
        self.programs("exit 0")
        runner = CommandRunner(cases.load(str(self.case)), ["output.interval=0.1"], ["--ranks-dem", "1"])
        there = self.place / "study/points/a"
        self.assertEqual(runner(Point((("coupling.window", "1e-3"),)), there), "")
        resolved = cases.read_toml(there / "case.toml")
        self.assertEqual((resolved["coupling"]["window"], resolved["output"]["interval"]), (1e-3, 0.1))
        self.assertEqual(results.read_summary(there)["status"], "completed")

    def test_reason_of_a_failure(self) -> None:
        self.programs("sleep 0.2; echo 'dem rank 0: made to fail' > \"$1/failure.txt\"; exit 1")
        runner = CommandRunner(cases.load(str(self.case)), [], [])
        self.assertEqual(runner(Point(()), self.place / "points/a"), "dem rank 0: made to fail")

    def test_reason_of_a_refusal(self) -> None:
        log = self.place / "a.log"
        log.write_text("bad   Courant number   2 limit 1\n      change fluid_dt = 0.1\nslidewave: refused\n")
        self.assertEqual(failure(self.place / "a", log),
                         "refused; bad Courant number 2 limit 1 change fluid_dt = 0.1")
        results.write_summary(self.place, {"status": "failed", "reason": "the programs ended with status 2"})
        log.write_text("slidewave: dem: MPI did not start within 10 s\n")
        self.assertEqual(failure(self.place, log), "dem: MPI did not start within 10 s")
        log.write_text("")
        self.assertIn("see its log", failure(self.place / "a", log))

    def test_stopped_study_goes_on(self) -> None:
        self.programs(WAIT)
        words = ["/usr/bin/python3", "-m", "launch", "study", str(self.case), "--out",
                 str(self.place / "study"), "--vary", "coupling.window=1e-3,5e-4"]
        child = subprocess.Popen(words, env=dict(os.environ, PYTHONPATH=str(ROOT)), text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        deadline = time.monotonic() + 60
        while not list(self.place.glob("study/points/*/history.csv")) and time.monotonic() < deadline:
            time.sleep(0.1)
        time.sleep(0.3)
        child.send_signal(signal.SIGTERM)
        text = child.communicate(timeout=60)[0]
        self.assertEqual(child.returncode, 1, text)
        self.assertIn("the same command goes on where it was", text)
        self.assertEqual(len(list(self.place.glob("study/points/*/history.csv"))), 1, "the second never ran")

    def test_time_left(self) -> None:
        there = self.place / "a"
        there.mkdir()
        (there / "summary.json").write_text(json.dumps({"wall_s": 4.0}))
        pace = Pace()
        self.assertEqual(pace.ahead([Job(Point(()), there, 10)], 1), "")
        pace.learn(Job(Point(()), there, 10), 7.0)
        self.assertEqual(pace.ahead([Job(Point(()), there, 20)] * 3, 1), ", about 33 s left")
        self.assertEqual([duration(s) for s in (42, 240, 9000)], ["42 s", "4.0 min", "2.5 h"])


if __name__ == "__main__":
    unittest.main()
