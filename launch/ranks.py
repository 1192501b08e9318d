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


FLUID_PROGRAMS = {"openfoam": "slidewave_foam", "uniform_flow": "slidewave_uniform"}
DEM_PROGRAMS = {"liggghts": "slidewave_dem", "lammps": "slidewave_lammps", "esys": "slidewave_esys"}
# Engines that a machine may lack: the Debian packages that bring them.
OPTIONAL_PACKAGES = {"slidewave_lammps": "liblammps-dev",
                     "slidewave_esys": "esys-particle libboost-dev libpython3-dev"}
FIXED_DEM_RANKS = {"esys": 2}  # a master and one worker


def sides(directory: Path, fluid: int, dem: int, fluid_engine: str,
          dem_engine: str = "liggghts") -> list[tuple[int, list[str]]]:
    """Ranks and command of each side that runs; the engines are fluid.engine, dem.engine of the case."""
    programs = [(fluid, FLUID_PROGRAMS.get(fluid_engine, "")), (dem, DEM_PROGRAMS.get(dem_engine, ""))]
    return [(ranks, [str(program(name)), str(directory)]) for ranks, name in programs if ranks]


def mpirun_alone() -> list[str]:
    """mpirun with the options that every run takes, before its programs."""
    words = ["mpirun", "--bind-to", "none", "--mca", "mpi_yield_when_idle", "1", "--oversubscribe"]
    return [*words, "--allow-run-as-root"] if os.geteuid() == 0 else words


def mpirun_words(directory: Path, fluid: int, dem: int, fluid_engine: str,
                 dem_engine: str = "liggghts") -> list[str]:
    """The plain mpirun line: `fluid` ranks of the fluid program and `dem` ranks of the particles'."""
    words = mpirun_alone()
    for number, (ranks, command) in enumerate(sides(directory, fluid, dem, fluid_engine, dem_engine)):
        words += ([":"] if number else []) + ["-np", str(ranks), *command]
    return words


def mpirun_line(directory: Path, fluid: int, dem: int, fluid_engine: str,
                dem_engine: str = "liggghts") -> str:
    """The same line for a shell."""
    return shlex.join(mpirun_words(directory, fluid, dem, fluid_engine, dem_engine))
