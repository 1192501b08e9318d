"""mpirun that does not leave after its programs, played by a shell that does not bury its children."""

import subprocess
import sys
import time
import unittest

from launch import mpirun_end

# Starts children that live for so long, does not wait for them, and stays.
HANGS = "import subprocess, sys, time; p = [subprocess.Popen(['sleep', t]) for t in sys.argv[1:]]; time.sleep(60)"


class End(unittest.TestCase):
    def wait(self, program: str, *words: str) -> tuple[int | None, float]:
        start = time.monotonic()
        child = subprocess.Popen([sys.executable, "-c", program, *words])
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        return mpirun_end.wait(child, dead_for_s=1.5), time.monotonic() - start

    def test_it_is_ended_once_all_its_programs_are_dead(self) -> None:
        status, took_s = self.wait(HANGS, "0.1", "4")
        self.assertIsNone(status)
        self.assertGreater(took_s, 5)  # the second still ran
        self.assertLess(took_s, 40)

    def test_its_own_status_counts_where_it_leaves(self) -> None:
        self.assertEqual(self.wait("import sys; sys.exit(3)")[0], 3)

    def test_programs_that_still_run_are_an_error_after_the_timeout(self) -> None:
        child = subprocess.Popen([sys.executable, "-c", HANGS, "30"])
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        with self.assertRaises(subprocess.TimeoutExpired):
            mpirun_end.wait(child, dead_for_s=1.5, timeout_s=2)

    def test_without_programs_it_is_left_alone(self) -> None:
        self.assertEqual(self.wait("import time; time.sleep(4)")[0], 0)


if __name__ == "__main__":
    unittest.main()
