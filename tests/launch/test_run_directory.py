"""No result is lost silently: refusal, --overwrite, and older runs kept as .1, .2."""

import contextlib
import os
import unittest

from launch import run_directory
from launch.errors import InputError
from tests.launch.scratch import ScratchCase


class RunDirectory(ScratchCase):
    def test_absent_and_empty_are_fine(self) -> None:
        (self.place / "run").mkdir()
        self.assertEqual(self.dry_run()[0], 0)

    def test_a_run_is_refused_then_overwritten(self) -> None:
        self.assertEqual(self.dry_run()[0], 0)
        (self.place / "run/history.csv").write_text("precious")
        status, _, err = self.dry_run()
        self.assertEqual(status, 2)
        self.assertIn("--overwrite", err)
        self.assertEqual((self.place / "run/history.csv").read_text(), "precious")
        self.assertEqual(self.dry_run("--overwrite")[0], 0)
        self.assertFalse((self.place / "run/history.csv").exists())

    def test_overwrite_spares_what_is_no_run(self) -> None:
        (self.place / "run").mkdir()
        (self.place / "run/thesis.tex").write_text("years")
        self.assertEqual(self.dry_run("--overwrite")[0], 2)
        self.assertTrue((self.place / "run/thesis.tex").exists())

    def test_default_place_keeps_older_runs(self) -> None:
        with contextlib.chdir(self.place):
            for number in range(3):
                self.assertEqual(self.slidewave("run", "sphere", "--dry-run")[0], 0)
                (self.place / "runs/settling_sphere-two_way/mark").write_text(str(number))
            marks = {p.name: (p / "mark").read_text() for p in (self.place / "runs").iterdir()}
        self.assertEqual(marks, {"settling_sphere-two_way": "2", "settling_sphere-two_way.1": "0",
                                 "settling_sphere-two_way.2": "1"})

    def test_refused_input_brings_the_older_run_back(self) -> None:
        with contextlib.chdir(self.place):
            place = run_directory.make(None, "c", "v", False)
            (place.directory / "old").touch()
            second = run_directory.make(None, "c", "v", False)
            second.withdraw()
            self.assertEqual(os.listdir("runs"), ["c-v"])
            self.assertEqual(os.listdir("runs/c-v"), ["old"])

    def test_a_file_is_no_directory(self) -> None:
        (self.place / "run").write_text("")
        with self.assertRaises(InputError):
            run_directory.make(self.place / "run", "c", "v", True)

    def test_ranks_and_decomposition(self) -> None:
        status, out, err = self.dry_run("--ranks-fluid", "3", "--ranks-dem", "2")
        self.assertEqual(status, 0, err)
        self.assertRegex(out, r"-np 3 \S*slidewave_foam \S+ : -np 2 \S*slidewave_dem")
        self.assertEqual(len(list((self.place / "run/fluid").glob("processor*/0/U"))), 3)

    def test_fluid_alone(self) -> None:
        self.change("case.toml", "[dem]\n", '[dem]\nengine = "none"\n')
        status, out, err = self.dry_run()
        self.assertEqual(status, 0, err)
        self.assertNotIn("slidewave_dem", out)
        self.assertFalse((self.place / "run/dem").exists())


if __name__ == "__main__":
    unittest.main()
