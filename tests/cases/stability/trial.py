"""One scene of the stability map: what the pre-flight check says, and what happens when it runs all the same."""

from __future__ import annotations

import contextlib
import io
import math
import os
import re
import shutil
import signal
import subprocess
import time
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from launch import case as cases
from launch import places, preflight, prepare, ranks, results
from launch.errors import InputError, RunError
from launch.places import ROOT
from tests.cases.stability.scene import Scene

BASES = {"column": ROOT / "tests/cases/stability/column", "pool": ROOT / "tests/cases/stability/pool",
         "standing_wave": ROOT / "cases/verification/standing_wave", "dam_break": ROOT / "cases/verification/dam_break"}
LONGEST_S = 400.0  # a run that takes longer counts as failed (seconds to two minutes on a quiet machine)
ACCURATE = 0.05
# Largest defects: what is given is what is received, volumes are kept. A run of a few windows near
# round-off shows 1e-11; each of the peers' known losses shows above 1e-4.
DEFECTS = {"momentum_defect": 1e-8, "solid_volume_defect": 1e-10, "water_volume_defect": 1e-5, "air_volume_defect": 1e-3}


@dataclass
class Outcome:
    """What was predicted and what was seen. `verdict`: ok, warn or bad of the check, or refused (bad input);
    `limiting`: its row; `stable`: ended well, finite, within energy and budgets."""

    title: str
    verdict: str = ""
    limiting: str = ""
    limit: str = ""
    stable: bool = False
    why: str = ""
    error: float = math.nan
    budgets: dict[str, float] = field(default_factory=dict)
    wall_s: float = 0.0

    @property
    def accepted(self) -> bool:
        return self.verdict in ("ok", "warn")

    @property
    def accurate(self) -> bool:
        """Within ACCURATE of its reference; so where there is none."""
        return not self.error > ACCURATE

    @property
    def good(self) -> bool:
        """Whether a user could use the run."""
        return self.stable and self.accurate


def attempt(scene: Scene, place: Path) -> Outcome:
    """Checks and runs a scene, and its finer stand-in where it has one, below `place`, which goes afterwards."""
    outcome = Outcome(scene.title)
    with contextlib.redirect_stdout(io.StringIO()):
        try:
            ready = _prepare(scene, {}, place / "run", scene.ranks)
        except (InputError, RunError) as error:
            outcome.verdict, outcome.why = "refused", " ".join(str(error).split())[:200]
            return outcome
        _note_check(outcome, *ready)
        history = _run(scene, outcome, ready[1])
        if history and outcome.stable:
            outcome.error = _error(scene, history, place)
    shutil.rmtree(place, ignore_errors=True)
    return outcome


def _prepare(scene: Scene, more: dict, place: Path, count: tuple[int, int]):
    settings = scene.words(more)[1::2]
    case = cases.load(str(BASES[scene.case]), None, settings)
    if case.get("dem.engine") == "none":
        case.data["observe"] = {k: v for k, v in case.data.get("observe", {}).items() if v["type"] == "gauge"}
    if case.get("fluid.engine") == "none":
        case.data.get("coupling", {}).pop("smoothing_length", None)
    prepare.check_input(case)
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    return case, prepare.prepare(case, place.resolve(), *count)


def _note_check(outcome: Outcome, case: cases.Case, ready: prepare.Prepared) -> None:
    rows = preflight.examine(case, ready)
    for verdict in ("bad", "warn", "ok"):
        found = [r for r in rows if r.verdict == verdict and isinstance(r.value, (int, float))]
        if found:
            row = max(found, key=lambda r: _strain(r.value, r.limit))
            outcome.verdict, outcome.limiting = verdict, row.quantity
            outcome.limit = f"{row.value:.3g} of {row.limit:.3g}" if row.limit else f"{row.value:.3g}"
            return
    outcome.verdict = "ok"


def _strain(value: float, limit: float | None) -> float:
    """How far over its limit a row is (of either kind), for the choice of the worst."""
    return abs(math.log(value / limit)) if value and limit and value / limit > 0 else 0.0


def _command(ready: prepare.Prepared, longest_s: float) -> tuple[int, str]:
    """Exit status (-1: too long) and the last line that says why."""
    words = ranks.mpirun_words(ready.directory, ready.ranks_fluid, ready.ranks_dem, ready.fluid_engine,
                               ready.dem_engine)
    with (ready.directory / "log").open("w+") as log:
        child = subprocess.Popen(words, stdout=log, stderr=log, env=places.openfoam_environment(),
                                 start_new_session=True)
        try:
            status = child.wait(timeout=longest_s)
        except subprocess.TimeoutExpired:
            os.killpg(child.pid, signal.SIGKILL)
            child.wait()
            return -1, f"more than {longest_s:g} s"
        log.seek(0)
        told = [line.strip() for line in log if re.search(r"slidewave|error|ERROR", line)]
    told = [line for line in told if "ORTE" not in line]
    return status, (told[-1] if told else f"exit status {status}")[:160]


def _run(scene: Scene, outcome: Outcome, ready: prepare.Prepared) -> dict[str, np.ndarray]:
    start = time.monotonic()
    status, told = _command(ready, LONGEST_S)
    outcome.wall_s = time.monotonic() - start
    history, summary = _history(ready.directory), results.read_summary(ready.directory)
    budgets = {k: v for k, v in (summary.get("budgets") or {}).items() if v is not None}
    outcome.budgets = budgets
    outcome.why = "" if status == 0 else told
    if status == 0:
        outcome.why = _fault(scene, history, budgets)
    outcome.stable = not outcome.why
    return history


def _fault(scene: Scene, history: dict[str, np.ndarray], budgets: dict[str, float]) -> str:
    """What is wrong with a run that ended, "" where nothing is."""
    for name, values in history.items():
        if not np.isfinite(values).all():
            return f"{name} is not finite"
    if "kinetic_energy_J" in history and scene.mass > 0:
        speed = math.sqrt(2 * history["kinetic_energy_J"].max() / scene.mass)
        if speed > 2 * scene.speed:
            return f"mean-square speed {speed:.2g} m/s, {speed / scene.speed:.2g} times what the energy allows"
    for name, largest in DEFECTS.items() if not scene.lost else ():  # what left took its last impulse along
        if budgets.get(name, 0.0) > largest:
            return f"{name} {budgets[name]:.2g}"
    if budgets.get("particles_lost", 0) and not scene.lost:
        return f"{budgets['particles_lost']:g} particles lost"
    return ""


def _history(directory: Path) -> dict[str, np.ndarray]:
    """history.csv, with the vertical velocity at the probe as `flow`."""
    history = results.read_history(directory)
    for path in directory.glob("fluid/postProcessing/probes/*/U"):
        rows = [re.sub(r"[()]", " ", line).split() for line in path.read_text().splitlines() if not line.startswith("#")]
        history["flow"] = np.array(rows, dtype=float)[:, 3]
    return history


def _error(scene: Scene, history: dict[str, np.ndarray], place: Path) -> float:
    if scene.error is not None:
        return scene.error(history)
    if scene.finer is None:
        return math.nan
    _, ready = _prepare(scene, scene.finer, place / "finer", scene.finer_ranks)
    if _command(ready, 3 * LONGEST_S)[0] != 0:
        return math.nan
    true = _history(ready.directory)
    expected = np.interp(history["time_s"], true["time_s"], true[scene.column])
    return float(np.abs(history[scene.column] - expected).max() / np.ptp(expected))
