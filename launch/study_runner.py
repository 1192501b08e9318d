"""Runs the points of a study: one `slidewave run` each, those that are complete are not run again."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from launch import places, progress, results
from launch.case import Case
from launch.study_points import Point

Runner = Callable[[Point, Path], str]  # runs a point into a directory; why it failed, "" where not
INPUTS = ("fluid", "dem", "geometry")


@dataclass(frozen=True)
class Job:
    """One run of one point, where it goes, and its cost over that of others (windows to run)."""

    point: Point
    directory: Path
    windows: float


def fingerprint(case: Case, more: list[object]) -> str:
    """Eight letters that change with the resolved case, its input files and `more`."""
    known = hashlib.sha256(json.dumps([case.data, more], sort_keys=True, default=str).encode())
    for path in sorted(p for side in INPUTS for p in (case.directory / side).rglob("*") if p.is_file()):
        known.update(str(path.relative_to(case.directory)).encode() + b"\0" + path.read_bytes())
    return known.hexdigest()[:8]


def is_complete(directory: Path) -> bool:
    """Whether a run ended well here."""
    return results.read_summary(directory).get("status") == "completed"


class CommandRunner:
    """Runs points as commands of their own, their output in DIRECTORY.log; stop() ends them well."""

    def __init__(self, case: Case, settings: list[str], options: list[str]) -> None:
        self._words = [str(case.directory), *(["--variant", case.variant] if case.variant else [])]
        self._settings, self._options = settings, options
        self._children: set[subprocess.Popen] = set()
        self._lock = threading.Lock()
        self._stopped = False

    def __call__(self, point: Point, directory: Path) -> str:
        shutil.rmtree(directory, ignore_errors=True)
        directory.parent.mkdir(parents=True, exist_ok=True)
        words = [sys.executable, "-m", "launch", "run", *self._words, "--out", str(directory),
                 *self._options]
        for setting in [*self._settings, *point.words]:
            words += ["--set", setting]
        environment = dict(os.environ)
        environment["PYTHONPATH"] = os.pathsep.join(
            filter(None, (str(places.ROOT), environment.get("PYTHONPATH"))))
        log = directory.with_name(directory.name + ".log")
        with log.open("wb") as stream:
            with self._lock:
                if self._stopped:
                    return "stopped"
                child = subprocess.Popen(words, stdout=stream, stderr=subprocess.STDOUT,
                                         env=environment, start_new_session=True)
                self._children.add(child)
            child.wait()
            with self._lock:
                self._children.discard(child)
        return "" if is_complete(directory) else failure(directory, log)

    def stop(self) -> None:
        """Asks every running point to leave at its next window end; starts no other."""
        with self._lock:
            self._stopped = True
            for child in self._children:
                child.send_signal(signal.SIGINT)


def failure(directory: Path, log: Path) -> str:
    """Why a run did not end well, in one line: from summary.json, else from what it printed."""
    summary = results.read_summary(directory)
    if summary.get("status") == "stopped":
        return "stopped before its end"
    reason = str(summary.get("reason", ""))
    lines = progress.last_lines(log, 60).splitlines()
    if not reason or reason.startswith("the programs ended with"):  # it does not say why
        bad = [" ".join(lines[i:i + 2]) for i, line in enumerate(lines) if line.startswith("bad ")]
        errors = [line.removeprefix("slidewave: ") for line in lines if line.startswith("slidewave: ")]
        reason = "; ".join(errors[-1:] + bad) or reason
    return " ".join(reason.split()) or "ended without a result; see its log"
