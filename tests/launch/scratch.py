"""A copy of settling_sphere in a temporary directory, to change and break, and the command line on it."""

from __future__ import annotations

import contextlib
import io
import shutil
import tempfile
import unittest
from pathlib import Path

from launch import cli
from launch.places import ROOT


def command_line(*arguments: str | Path) -> tuple[int, str, str]:
    """Exit status, standard output and standard error of one command."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = cli.main([str(a) for a in arguments])
        except SystemExit as end:  # argparse
            status = int(end.code or 0)
    return status, out.getvalue(), err.getvalue()


class ScratchCase(unittest.TestCase):
    """self.place: temporary directory; self.case: the copy."""

    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.place = Path(holder.name).resolve()
        self.case = self.place / "sphere"
        shutil.copytree(ROOT / "cases/settling_sphere", self.case)

    def change(self, file: str, old: str, new: str) -> None:
        """Replaces text that must be there."""
        path = self.case / file
        text = path.read_text()
        self.assertIn(old, text, f"{file} no longer holds the text that this test changes")
        path.write_text(text.replace(old, new, 1))

    def slidewave(self, *arguments: str) -> tuple[int, str, str]:
        """Exit status, standard output and standard error of one command."""
        return command_line(*arguments)

    def dry_run(self, *more: str) -> tuple[int, str, str]:
        """`run --dry-run` of the copy into self.place/run."""
        return self.slidewave("run", self.case, "--dry-run", "--out", self.place / "run", *more)
