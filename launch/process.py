"""Starts mpirun and sees it through: progress passes to the terminal, signals go to the programs."""

from __future__ import annotations

import signal
import subprocess
import time
from pathlib import Path

from launch import mpirun_end, places, progress, ranks, results
from launch.errors import RunError
from launch.prepare import Prepared


class Clock:
    """Wall time since it was made [s]."""

    def __init__(self) -> None:
        self._start = time.monotonic()

    def elapsed_s(self) -> float:
        return time.monotonic() - self._start


def check_programs(words: list[str]) -> None:
    """Refuses a line whose programs are not built."""
    for word in words:
        if Path(word).name.startswith("slidewave_") and "/" in word and not Path(word).is_file():
            raise RunError(f"{word} is not built; run ./slidewave setup")


def run(ready: Prepared) -> int:
    """Runs a prepared directory; gives mpirun's exit status (128 + number where a signal ended it). Where mpirun
    itself hangs after its programs it is ended, and what they wrote tells the status.

    SIGINT and SIGTERM ask the programs to leave at the next window end: mpirun hands SIGUSR1 to every
    rank. A second signal ends them at once."""
    words = ranks.mpirun_words(ready.directory, ready.ranks_fluid, ready.ranks_dem,
                               ready.fluid_engine, ready.dem_engine)
    check_programs(words)
    try:
        child = subprocess.Popen(words, env=places.openfoam_environment(), start_new_session=True)
    except FileNotFoundError as error:
        raise RunError("mpirun: no such program; run ./slidewave setup") from error
    asked = False

    def forward(number: int, _frame: object) -> None:
        nonlocal asked
        child.send_signal(number if asked else signal.SIGUSR1)
        asked = True

    watched = (signal.SIGINT, signal.SIGTERM, signal.SIGUSR1, signal.SIGHUP)
    previous = {number: signal.signal(number, forward) for number in watched
                if signal.getsignal(number) != signal.SIG_IGN}  # nohup stays nohup
    try:
        status = mpirun_end.wait(child)
    finally:
        for number, handler in previous.items():
            signal.signal(number, handler)
    if status is None:
        progress.say("mpirun did not leave after its programs: ended")
        done = results.read_summary(ready.directory).get("status") in ("completed", "stopped")
        return 0 if done and not (ready.directory / "failure.txt").exists() else 1
    return status if status >= 0 else 128 - status
