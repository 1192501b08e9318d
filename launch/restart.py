"""Goes on with a run directory from its newest complete checkpoint: DIR as it was prepared, on other
ranks too. The programs choose and check the checkpoint themselves."""

from __future__ import annotations

import json
import re
import time
from dataclasses import dataclass
from pathlib import Path

from launch import facts, parameters, prepare, progress, run_directory, schema
from launch.case import Case, read_toml
from launch.errors import InputError

# What may change from one part of a run to the next: nothing that the state depends on.
FREE = ("case.end_time", "case.title", "case.default_variant", "coupling.patience", "checkpoint.",
        "check.", "output.headline", "target")


# Chosen when the run was prepared.
CHOSEN = (("coupling.regime", "auto"), ("coupling.scheme", "auto"))


@dataclass
class Checkpoint:
    """A finished checkpoint, as its manifest tells: window, time [s], ranks of both sides."""

    window: int
    time_s: float
    ranks_fluid: int
    ranks_dem: int


def newest(directory: Path) -> Checkpoint | None:
    """The newest checkpoint that has a manifest; whether its files are whole is the programs' to say."""
    for file in sorted(directory.glob("checkpoints/*/manifest.json"), reverse=True):
        try:
            found = json.loads(file.read_text())
            return Checkpoint(found["window"], found["time_s"], found["fluid_ranks"], found["dem_ranks"])
        except (OSError, ValueError, KeyError):
            continue
    return None


def take_up(case: Case, directory: Path, ranks_fluid: int | None,
            ranks_dem: int | None) -> prepare.Prepared:
    """A prepared directory again, with the changes that a restart allows. InputError for others."""
    start = time.monotonic()
    if not run_directory.holds_run(directory):
        raise InputError(directory, "--restart", None, "holds no run to go on with; leave --restart out")
    stored = read_toml(directory / "case.toml")
    run = stored.pop("run")
    kept = Case(case.directory, run["variant"], stored)
    changed = _changes(case, kept, directory)
    for key in changed:
        kept.put(key, case.get(key))
    fluid = ranks_fluid or run["ranks_fluid"]
    dem = ranks_dem or run["ranks_dem"]
    if case.get("fluid.engine") == "none":
        fluid = 0
    if case.get("dem.engine") == "none":
        dem = 0
    known = facts.gather(kept, directory)
    if case.get("fluid.engine") == "openfoam" and fluid != run["ranks_fluid"]:
        _decompose_again(directory / "fluid", directory, known, run["ranks_fluid"], fluid)
    if changed or (fluid, dem) != (run["ranks_fluid"], run["ranks_dem"]):
        if "case.end_time" in changed:
            _set_end_time(directory, case.get("case.end_time"))
        prepare.write_case(kept, directory, fluid, dem)
    found = newest(directory)
    progress.say(f"going on after window {found.window}, t = {found.time_s:.6g} s" if found else
                 "no complete checkpoint: beginning at the start")
    return prepare.Prepared(directory, known, fluid, dem, time.monotonic() - start,
                            case.get("fluid.engine"))


def _changes(case: Case, kept: Case, directory: Path) -> list[str]:
    """Keys whose value in the case differs from the run's and may."""
    changed = []
    for key, value in schema.leaves({k: v for k, v in case.data.items() if k != "target"}):
        if kept.get(key) == value or (key, value) in CHOSEN:
            continue
        if not key.startswith(FREE):
            raise InputError(directory / "case.toml", key, kept.get(key),
                             f"the case now says {value!r}: a restart goes on with the run as it was "
                             "prepared; only end time, checkpoints, patience and targets may change")
        changed.append(key)
    if case.get("target") != kept.get("target"):
        changed.append("target")
    return changed


def _set_end_time(directory: Path, end_time: float) -> None:
    text = parameters.number_text(end_time)
    for name, pattern in (("fluid/parameters", r"(?m)^(end_time) .*;$"),
                          ("dem/parameters", r"(?m)^(variable end_time index) .*$")):
        file = directory / name
        if file.is_file():
            tail = ";" if name.startswith("fluid") else ""
            file.write_text(re.sub(pattern, rf"\g<1> {text}{tail}", file.read_text()))


def _decompose_again(fluid: Path, directory: Path, known: facts.Facts, before: int, now: int) -> None:
    """New pieces of the mesh; those of before keep the pictures they hold, in another place."""
    if before > 1:
        kept = fluid / f"ranks-{before}"
        number = 1
        while kept.exists():
            number += 1
            kept = fluid / f"ranks-{before}.{number}"
        kept.mkdir()
        for piece in fluid.glob("processor*"):
            piece.rename(kept / piece.name)
        progress.say(f"pictures of the fluid so far are in {kept}")
    prepare.decompose(fluid, directory, known.mesh, now)
