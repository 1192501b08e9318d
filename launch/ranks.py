"""How many ranks each side gets, and the mpirun line."""

from __future__ import annotations

import os
import shlex
from pathlib import Path

from launch.places import program

CELLS_A_RANK = 5000
PARTICLES_A_RANK = 4000


def cores() -> int:
    """Cores that this process may use."""
    return len(os.sched_getaffinity(0))


def suggested(amount: int, per_rank: int) -> int:
    """Ranks for `amount` cells or particles. Both sides share all cores: in the serial scheme one
    side sleeps while the other works."""
    return max(1, min(cores(), amount // per_rank))


def mpirun_words(directory: Path, fluid: int, dem: int) -> list[str]:
    """The plain mpirun line: `fluid` ranks of slidewave_foam and `dem` ranks of slidewave_dem."""
    words = ["mpirun", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1", "--oversubscribe"]
    if os.geteuid() == 0:
        words.append("--allow-run-as-root")
    sides = []
    if fluid:
        sides.append(["-np", str(fluid), str(program("slidewave_foam")), str(directory)])
    if dem:
        sides.append(["-np", str(dem), str(program("slidewave_dem")), str(directory)])
    return words + sides[0] + ([":", *sides[1]] if len(sides) > 1 else [])


def mpirun_line(directory: Path, fluid: int, dem: int) -> str:
    """The same line for a shell."""
    return shlex.join(mpirun_words(directory, fluid, dem))
