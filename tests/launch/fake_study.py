"""A study without engines: the fake runner writes what a run would, from formulas of the settings."""

from __future__ import annotations

import contextlib
import io
import json
import threading
from collections.abc import Callable
from pathlib import Path

from launch import cli
from launch.commands import study
from launch.errors import InputError
from launch.study_points import Point
from tests.launch.scratch import ScratchCase


class FakeRunner:
    """Writes history.csv and summary.json: final value and wall time [s] by `value` and `cost`."""

    def __init__(self, value: Callable[[Point], float], cost: Callable[[Point], float] = lambda _: 1.0,
                 fails: Callable[[Point], bool] = lambda _: False) -> None:
        self.value, self.cost, self.fails = value, cost, fails
        self.seen: list[str] = []
        self._lock = threading.Lock()

    def __call__(self, point: Point, directory: Path) -> str:
        with self._lock:
            self.seen.append(point.label)
        directory.mkdir(parents=True, exist_ok=True)
        if self.fails(point):
            return "dem rank 0: made to fail"
        rows = ["window,time_s,sphere_vz_m_s", "0,0,0", f"1,0.05,{self.value(point) / 2!r}",
                f"2,0.1,{self.value(point)!r}"]
        (directory / "history.csv").write_text("\n".join(rows) + "\n")
        (directory / "summary.json").write_text(json.dumps({
            "status": "completed", "wall_s": self.cost(point), "core_s": 2 * self.cost(point),
            "windows": 2, "budgets": {"momentum_defect": 1e-16}, "version": "made up"}))
        return ""


class StudyCase(ScratchCase):
    """A copy of settling_sphere and the study command on it with a fake runner."""

    def study(self, runner: FakeRunner, *words: str) -> tuple[int, str]:
        """Exit status and output; the directory is self.place/study. InputError passes through."""
        arguments = ["study", str(self.case), "--out", str(self.place / "study"), *words]
        options = cli.parser().parse_args(arguments)
        out = io.StringIO()
        with contextlib.redirect_stdout(out):
            status = study.main(options, runner)
        return status, out.getvalue()

    def refused(self, *words: str) -> str:
        """The message about bad input; nothing may have run."""
        runner = FakeRunner(lambda _: 1.0)
        with self.assertRaises(InputError) as caught:
            self.study(runner, *words)
        self.assertEqual(runner.seen, [])
        return str(caught.exception)
