"""bench coupling: what the coupling costs on cases/benchmark_bed, per particle and window.

Nanoseconds are processor time, the mean over a side's ranks, both sides added up: what a window waits for
in the serial scheme on a core a rank. The difference of a long and a short run, so that the start is not
counted. Bytes are peak memory of all ranks, less that of the two programs alone on the same scene, less
the same of a scene of a few particles."""

from __future__ import annotations

import argparse
import functools
import shutil
import statistics
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from launch import case as cases
from launch import places, prepare, rank_usage, ranks, results
from launch.errors import RunError
from launch.progress import say

QUICK = [("n1e4", 1), ("n1e4", 2), ("n1e5", 1), ("n1e5", 2)]
LARGE = [("n5e5", 1), ("n5e5", 2), ("n1e6", 1)]
FEW = ["parameters.width=0.008", "parameters.cells=4", "parameters.layers=4"]  # 196 particles
SHORT, LONG = 2, 12  # windows
PHASES = {"exchange_ns": "exchange", "locate_ns": "locate", "void_fraction_ns": "void_fraction",
          "force_ns": "force"}
ALONE = {"fluid": ("dem.engine=none", "coupling.reaction=one_way"), "dem": ("fluid.engine=none",)}


@dataclass
class Spent:
    """Of one run: particles, processor seconds a phase (a rank's, both sides), memory of all ranks."""

    particles: int
    seconds: dict[str, float]
    memory_bytes: float


def measure(options: argparse.Namespace) -> dict[str, object]:
    """All rows of DESIGN.md 9."""
    wanted = QUICK + (LARGE if options.large else [])
    rows = []
    for variant, count in wanted:
        rows.append(row(variant, count, options.repeats))
        say("  ".join(f"{k} {v:.4g}" for k, v in rows[-1].items()))
    return {"rows": rows}


def row(variant: str, count: int, repeats: int = 1, windows: tuple[int, int] = (SHORT, LONG),
        settings: list[str] | None = None) -> dict[str, float]:
    """One size on `count` ranks a side; medians over `repeats` pairs of a short and a long run."""
    pairs = [tuple(coupled(variant, count, n, settings) for n in windows) for _ in range(repeats)]
    particles = pairs[0][1].particles
    per = 1e9 / (particles * (windows[1] - windows[0]))
    found: dict[str, float] = {"n": particles, "ranks": count}
    for name, phase in PHASES.items():
        found[name] = per * statistics.median(b.seconds[phase] - a.seconds[phase] for a, b in pairs)
    found["total_ns"] = sum(found[name] for name in PHASES)
    for side in ALONE:
        found[f"{side}_ns"] = per * statistics.median(b.seconds[side] - a.seconds[side] for a, b in pairs)
    few = _of_few(count)
    more = _beyond_alone(variant, count, settings or [], pairs[0][0]) - few[1]
    found["bytes_per_particle"] = more / max(1, particles - few[0])
    return found


@functools.cache
def _of_few(count: int) -> tuple[int, float]:
    both = coupled("n1e4", count, SHORT, FEW)
    return both.particles, _beyond_alone("n1e4", count, FEW, both)


def _beyond_alone(variant: str, count: int, settings: list[str], both: Spent) -> float:
    """Bytes of a coupled run beyond those of its two programs alone."""
    alone = [_run(variant, count, SHORT, settings + list(extra)) for extra in ALONE.values()]
    return both.memory_bytes - sum(spent.memory_bytes for spent in alone)


def coupled(variant: str, count: int, windows: int, settings: list[str] | None) -> Spent:
    """A run of both programs."""
    return _run(variant, count, windows, settings or [])


def _run(variant: str, count: int, windows: int, settings: list[str]) -> Spent:
    case = cases.load("benchmark_bed", variant, settings)
    case.put("case.end_time", windows * case.get("coupling.window"))
    prepare.check_input(case)
    with tempfile.TemporaryDirectory(prefix="slidewave-bench-") as name:
        place = Path(name).resolve() / "run"
        place.mkdir()
        ready = prepare.prepare(case, place, count, count)
        words = ranks.mpirun_words(place, ready.ranks_fluid, ready.ranks_dem, ready.fluid_engine,
                                   ready.dem_engine)
        done = subprocess.run(rank_usage.wrapped(words, place / "usage"), env=rank_usage.environment(),
                              capture_output=True, text=True, check=False, timeout=3600)
        if done.returncode:
            raise RunError(f"benchmark_bed failed:\n{done.stdout[-1500:]}{done.stderr[-500:]}")
        summary = results.read_summary(place)
        memory = sum(rank["memory_bytes"] for rank in rank_usage.read(place / "usage"))
        shutil.rmtree(place)
    timings = summary["processor_timings"]
    seconds = {phase: sum(side[phase] for side in timings.values()) for phase in PHASES.values()}
    seconds |= {side: phases["solve"] for side, phases in timings.items()}
    return Spent(int(summary["particles"]), seconds, memory)
