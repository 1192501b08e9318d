"""What one rank of a program costs: python3 -m launch.rank_usage FILE PROGRAM ARGUMENTS...

Runs the program and writes FILE.<rank> with its peak memory [bytes] and processor time [s] as JSON. Goes
before the program in an mpirun line; the program finds its place among the ranks in the environment."""

from __future__ import annotations

import json
import os
import resource
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from launch import places

WRAPPER = (sys.executable, "-m", "launch.rank_usage")


def wrapped(words: Sequence[str], file: Path) -> list[str]:
    """An mpirun line whose programs (slidewave_...) write FILE.<rank>."""
    line: list[str] = []
    for word in words:
        if "/" in word and Path(word).name.startswith("slidewave_"):
            line += [*WRAPPER, str(file)]
        line.append(word)
    return line


def environment() -> dict[str, str]:
    """That of OpenFOAM's programs, in which the wrapper finds this package."""
    return places.openfoam_environment() | {"PYTHONPATH": str(places.ROOT), "PYTHONDONTWRITEBYTECODE": "1"}


def read(file: Path) -> list[dict[str, float]]:
    """What the ranks wrote, in their order."""
    parts = sorted(file.parent.glob(f"{file.name}.*"), key=lambda p: int(p.suffix[1:]))
    return [json.loads(part.read_text()) for part in parts]


def main(arguments: Sequence[str]) -> int:
    """Runs the program; its exit status."""
    rank = os.environ.get("OMPI_COMM_WORLD_RANK", "0")
    status = subprocess.run(list(arguments[1:]), check=False).returncode
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    Path(f"{arguments[0]}.{rank}").write_text(json.dumps(
        {"memory_bytes": 1024 * used.ru_maxrss, "processor_s": used.ru_utime + used.ru_stime}))
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
