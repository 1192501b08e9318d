"""The bootstrap script where it may not install: names what is missing, stops with 2, changes nothing."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

from launch.places import ROOT

ABSENT = "slidewave-no-such-package"


class Bootstrap(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name)
        shutil.copy(ROOT / "slidewave", self.place)
        (self.place / "launch").mkdir()
        packages = (ROOT / "launch/packages.txt").read_text() + f"{ABSENT}  for this test\n"
        (self.place / "launch/packages.txt").write_text(packages)
        for name, text in (("id", "echo 1000"), ("sudo", "exit 1")):
            stub = self.place / "stubs" / name
            stub.parent.mkdir(exist_ok=True)
            stub.write_text(f"#!/bin/sh\n{text}\n")
            stub.chmod(0o755)

    def slidewave(self, *arguments: str) -> subprocess.CompletedProcess:
        environment = {"PATH": f"{self.place}/stubs:{os.environ['PATH']}"}
        return subprocess.run([str(self.place / "slidewave"), *arguments], env=environment,
                              capture_output=True, text=True, timeout=60, stdin=subprocess.DEVNULL,
                              check=False)

    def test_without_rights_it_names_what_is_missing(self) -> None:
        for arguments in (("setup",), ("run", "cases/settling_sphere"), ("test",)):
            done = self.slidewave(*arguments)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(f"missing packages: {ABSENT}", done.stderr)
            self.assertIn("apt-get install", done.stderr)
        self.assertFalse((self.place / "build").exists())

    def test_list_tells_and_help_installs_nothing(self) -> None:
        done = self.slidewave("setup", "--list")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, rf"(?m)^missing +{ABSENT} +for this test$")
        self.assertRegex(done.stdout, r"(?m)^installed +python3 ")
        done = self.slidewave("--help")
        self.assertEqual((done.returncode, ABSENT in done.stdout), (0, True))

    def test_optional_packages_are_listed_and_not_missed(self) -> None:
        with (self.place / "launch/packages.txt").open("a") as packages:
            packages.write("?slidewave-no-such-engine  for this test, too\n")
        done = self.slidewave("setup", "--list")
        self.assertRegex(done.stdout, r"(?m)^optional +slidewave-no-such-engine +for this test, too$")
        self.assertRegex(done.stdout, r"(?m)^(installed|optional) +liblammps-dev ")
        self.assertNotIn("no-such-engine", self.slidewave("setup").stderr)

    def test_unknown_option(self) -> None:
        self.assertEqual(self.slidewave("setup", "--everything").returncode, 2)


if __name__ == "__main__":
    unittest.main()
