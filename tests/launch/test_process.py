"""Starting the programs: exit status, reason of a failure, signals. Two shell scripts stand in for
the two programs, so that mpirun and the command line are tested alone."""

import os
import signal
import subprocess
import time
import unittest

from launch import results
from launch.places import ROOT
from tests.launch.scratch import ScratchCase

OK = "exit 0"
FAIL = "sleep 0.2; echo 'dem rank 0: made to fail' > \"$1/failure.txt\"; exit 1"
BAD_INPUT = "exit 2"
HISTORY = "printf 'window,time_s,sphere_vz_m_s\\n0,0,0\\n1,0.1,-0.0133\\n' > \"$1/history.csv\"\n"
WAIT = "trap 'echo asked > \"$1/asked\"; exit 0' USR1; i=0; while [ $i -lt 300 ]; do sleep 0.1; i=$((i+1)); done"


class Process(ScratchCase):
    def start(self, fluid: str, dem: str) -> subprocess.Popen:
        for name, text in (("slidewave_foam", fluid), ("slidewave_dem", HISTORY + dem)):
            path = self.place / "bin" / name
            path.parent.mkdir(exist_ok=True)
            path.write_text(f"#!/bin/sh\n{text}\n")
            path.chmod(0o755)
        environment = dict(os.environ, SLIDEWAVE_BUILD=str(self.place), PYTHONPATH=str(ROOT))
        return subprocess.Popen(
            ["/usr/bin/python3", "-m", "launch", "run", str(self.case), "--out", str(self.place / "run")],
            env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def finished(self, child: subprocess.Popen) -> tuple[int, dict]:
        text = child.communicate(timeout=60)[0]
        self.output = text
        return child.returncode, results.read_summary(self.place / "run")

    def test_both_end_well(self) -> None:
        status, summary = self.finished(self.start(OK, OK))
        self.assertEqual((status, summary["status"]), (0, "completed"), self.output)
        self.assertTrue((self.place / "run/report.html").is_file())
        self.assertGreaterEqual(summary["total_s"], summary["prepare_s"])

    def test_either_fails(self) -> None:
        for fluid, dem in ((FAIL, OK), (OK, FAIL), (FAIL, FAIL)):
            with self.subTest(fluid=fluid, dem=dem):
                status, summary = self.finished(self.start(fluid, dem))
                self.assertEqual((status, summary["status"]), (1, "failed"), self.output)
                self.assertEqual(summary["reason"], "dem rank 0: made to fail")
                self.assertIn("made to fail", self.output)
                subprocess.run(["rm", "-r", str(self.place / "run")], check=True)

    def test_bad_input_found_by_a_program(self) -> None:
        self.assertEqual(self.finished(self.start(BAD_INPUT, OK))[0], 2, self.output)

    def test_required_target_missed(self) -> None:
        self.change("case.toml", "reference = -0.013275", "reference = -0.02")
        status, summary = self.finished(self.start(OK, OK))
        self.assertEqual((status, summary["targets"][0]["pass"]), (1, False))
        self.assertIn("required targets missed: terminal velocity", self.output)

    def test_not_built(self) -> None:
        child = self.start(OK, OK)
        (self.place / "bin/slidewave_dem").unlink()
        status, _ = self.finished(child)
        self.assertEqual(status, 1)
        self.assertIn("is not built", self.output)

    def test_first_signal_asks_the_programs_to_leave(self) -> None:
        child = self.start(WAIT, WAIT)
        deadline = time.monotonic() + 30
        while not (self.place / "run/history.csv").exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        self.finished(child)
        self.assertTrue((self.place / "run/asked").is_file(), self.output)

    def test_second_signal_ends_them(self) -> None:
        deaf = WAIT.replace("trap 'echo", "trap '' INT; trap ': echo").replace("exit 0", "true")
        child = self.start(deaf, deaf)
        deadline = time.monotonic() + 30
        while not (self.place / "run/history.csv").exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        time.sleep(0.3)
        child.send_signal(signal.SIGTERM)
        time.sleep(0.5)
        self.assertIsNone(child.poll(), "the first signal should only ask")
        start = time.monotonic()
        child.send_signal(signal.SIGTERM)
        status, summary = self.finished(child)
        self.assertLess(time.monotonic() - start, 15)
        self.assertEqual((status, summary["status"]), (1, "failed"), self.output)


if __name__ == "__main__":
    unittest.main()
