"""What the user sees of slow steps, and the log of each utility."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Sequence
from pathlib import Path

from launch.errors import RunError


def say(line: str) -> None:
    """A line for the user, at once."""
    print(line, flush=True)


def last_lines(path: Path, count: int = 12) -> str:
    """The end of a text file, for error messages."""
    try:
        return "\n".join(path.read_text(errors="replace").splitlines()[-count:])
    except OSError:
        return ""


def utility(command: Sequence[str], log: Path, environment: dict[str, str], cwd: Path) -> None:
    """Runs a program with its output in `log`; RunError with the end of the log where it fails."""
    start = time.monotonic()
    try:
        with log.open("wb") as stream:
            status = subprocess.run(list(command), stdout=stream, stderr=subprocess.STDOUT, cwd=cwd,
                                    env=environment, check=False).returncode
    except FileNotFoundError as error:
        raise RunError(f"{command[0]}: no such program; run ./slidewave setup") from error
    if status != 0:
        raise RunError(f"{Path(command[0]).name} failed (status {status}), see {log}:\n{last_lines(log)}")
    say(f"  {Path(command[0]).name:<14} {time.monotonic() - start:6.1f} s")
