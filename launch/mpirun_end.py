"""The end of mpirun, which may come after that of its programs, or never.

Open MPI 4.1 with PMIx 4.2 (Debian 12) can lock itself in PMIx_server_finalize once its last rank has ended: seen
once, in a test that kills ranks. All its children are then dead and not buried."""

from __future__ import annotations

import math
import subprocess
import time
from pathlib import Path

DEAD_FOR_S = 10.0  # a sound mpirun leaves within a second
LOOK_S = 1.0


def wait(mpirun: subprocess.Popen, dead_for_s: float = DEAD_FOR_S, timeout_s: float = math.inf) -> int | None:
    """Exit status of mpirun; None where it was ended here, since its programs had been dead for `dead_for_s`.
    subprocess.TimeoutExpired where programs still run after `timeout_s`."""
    start = alive = time.monotonic()
    while True:
        try:
            return mpirun.wait(timeout=LOOK_S)
        except subprocess.TimeoutExpired:
            pass
        if not all_dead(mpirun.pid):
            alive = time.monotonic()
            if alive - start > timeout_s:
                raise subprocess.TimeoutExpired(mpirun.args, timeout_s)
        elif time.monotonic() - alive > dead_for_s:
            mpirun.kill()
            mpirun.wait()
            return None


def all_dead(parent: int) -> bool:
    """Whether a process has children and none of them runs (on other nodes: those that keep the ranks there)."""
    states = []
    for listed in Path(f"/proc/{parent}/task").glob("*/children"):
        try:
            for child in listed.read_text().split():
                states.append(Path(f"/proc/{child}/stat").read_text().rpartition(")")[2].split()[0])
        except OSError:
            return False  # one went while we looked
    return bool(states) and set(states) == {"Z"}
