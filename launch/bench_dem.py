"""bench dem: the packaged linear contact law and ours (model linear), same constants, same steps.

Times are processor time of slidewave_dem, the set-up (a run of 0 steps) taken off. The settled bed is
kept in .cache. SI units."""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

from launch import bench_scenes as scenes
from launch import case as cases
from launch import places, prepare, ranks
from launch.errors import RunError
from launch.progress import say

LAWS = ("packaged", "own")
BED_STEPS, SLIDE_STEPS, COMPARED_STEPS = 400, 2500, 1000
# Contact distance factor at which the packaged law forgets the spring of an open contact, as ours does
# (docs/contact.md); its default, 1, keeps the spring until the neighbour list is built anew.
FORGETS = 1.1


def measure(options: argparse.Namespace) -> dict[str, object]:
    """All numbers of DESIGN.md 9, and the speeds behind them [particle-steps/s]."""
    count = options.size or 25000
    with tempfile.TemporaryDirectory(prefix="slidewave-bench-") as name:
        place = Path(name)
        shutil.copyfile(settled_bed(count), place / "bed.data")
        scenes.write_bed(place, count)
        numbers: dict[str, object] = {"spheres": count}
        numbers["max_position_difference"] = _difference(place)
        numbers |= _speeds(place, "bed", count, BED_STEPS, options.repeats)
        numbers |= _two_ranks(place, options.repeats)
        numbers |= _slide(place, options.repeats)
    return numbers


def _two_ranks(place: Path, repeats: int, steps: int = 1500) -> dict[str, float]:
    """How much faster two ranks go through the bed than one, our law. Wall time of the loop: it means
    something where two cores are free; `two_rank_cores` are the cores that the two ranks got,
    `two_rank_balance` the larger share of the spheres over the mean."""
    speedups, cores = [], []
    for number in range(repeats):
        loop_s = {}
        for count in (1, 2):
            command = [*ranks.mpirun_alone(), "-np", str(count), *_words("bed.in", {"law": "own", "steps": steps})]
            before, start = os.times(), time.monotonic()
            text = _finished(command, place)
            wall_s, after = time.monotonic() - start, os.times()
            loop_s[count] = float(re.findall(r"Loop time of (\S+) on", text)[-1])
        cores.append((after.children_user - before.children_user) / wall_s)
        speedups.append(loop_s[1] / loop_s[2])
        say(f"bed on two ranks, pair {number + 1}: {speedups[-1]:.2f} times one ({cores[-1]:.2f} cores)")
    mean, most = map(float, re.findall(r"Nlocal: +(\S+) ave (\S+) max", text)[-1])
    return {"ratio_two_ranks": statistics.median(speedups), "two_rank_cores": statistics.median(cores),
            "two_rank_balance": most / mean}


def _slide(place: Path, repeats: int) -> dict[str, float]:
    """Both laws in the slab that the packaged one needs, two diameters wide, and ours in the case's own:
    the same physics for the packaged law's seconds over ours."""
    wide, thin = (_prepare_slide(place, name, settings)
                  for name, settings in (("slide", ["geometry.slab_diameters=2"]), ("thin", [])))
    numbers = _speeds(place, "slide", wide, SLIDE_STEPS, repeats)
    setup_s = _run(place, "thin.in", {"law": "own", "steps": 0})
    own_s = [_run(place, "thin.in", {"law": "own", "steps": SLIDE_STEPS}) - setup_s for _ in range(repeats)]
    numbers["thin_own_per_s"] = thin * SLIDE_STEPS / statistics.median(own_s)
    packaged_s = wide * SLIDE_STEPS / numbers["slide_packaged_per_s"]
    numbers["ratio_slide_end_to_end"] = packaged_s / statistics.median(own_s)
    return numbers


def settled_bed(count: int) -> Path:
    """A data file with `count` spheres of 1.8 to 3.8 m at rest in a box; made once."""
    kept = places.ROOT / ".cache" / f"bench-bed-{count}.data"
    if kept.is_file():
        return kept
    say(f"settling {count} spheres (a minute or two, once)")
    with tempfile.TemporaryDirectory(prefix="slidewave-bed-") as name:
        place = Path(name)
        scenes.write_loose(place, count)
        _run(place, "settle.in", {})
        rows = scenes.last_snapshot(place / "settled.dump")
        kept.parent.mkdir(exist_ok=True)
        partial = kept.with_suffix(f".{os.getpid()}")
        scenes.write_data(partial, rows[:, 1:4], 2 * rows[:, 4], scenes.bed_width(count))
        partial.rename(kept)
    return kept


def _difference(place: Path, steps: int = COMPARED_STEPS, factor: float = FORGETS) -> float:
    """Largest distance between a sphere's places under the two laws, in its diameters. `factor`: contact
    distance factor of the packaged law."""
    end = {}
    for law in LAWS:
        _run(place, "bed.in", {"law": law, "steps": steps, "dumping": 1,
                               "factor": factor if law == "packaged" else 1})
        end[law] = scenes.last_snapshot(place / f"{law}.dump")
    away = np.linalg.norm(end["own"][:, 1:4] - end["packaged"][:, 1:4], axis=1)
    return float((away / (2 * end["own"][:, 4])).max())


def _speeds(place: Path, scene: str, particles: int, steps: int, repeats: int) -> dict[str, float]:
    setup = {law: _run(place, f"{scene}.in", {"law": law, "steps": 0}) for law in LAWS}
    speeds: dict[str, list[float]] = {law: [] for law in LAWS}
    for number in range(repeats):
        for law in LAWS:
            spent = _run(place, f"{scene}.in", {"law": law, "steps": steps}) - setup[law]
            speeds[law].append(particles * steps / max(spent, 1e-9))
        say(f"{scene}, pair {number + 1}: packaged {speeds['packaged'][-1] / 1e6:.2f}, "
            f"own {speeds['own'][-1] / 1e6:.2f} million particle-steps/s")
    ratios = [own / packaged for own, packaged in zip(speeds["own"], speeds["packaged"])]
    return {f"ratio_{scene}": statistics.median(ratios),
            f"{scene}_packaged_per_s": statistics.median(speeds["packaged"]),
            f"{scene}_own_per_s": statistics.median(speeds["own"])}


def _prepare_slide(place: Path, name: str, settings: list[str]) -> int:
    """NAME.in: the quick slide of vajont_east without water, at the moment of release; number of particles."""
    case = cases.load("vajont_east", "dry", settings)
    prepare.check_input(case)
    ready = prepare.prepare(case, place / name, 1, 1)
    scenes.write_slide(place, name, case.parameters)
    return ready.facts.particles


def _words(script: str, variables: dict[str, object]) -> list[str]:
    words = [str(places.program("slidewave_dem")), "--script", script, "-log", "none"]
    return words + [word for name, value in variables.items() for word in ("-var", name, str(value))]


def _finished(command: list[str], place: Path) -> str:
    """What a command that must succeed says."""
    done = subprocess.run(command, cwd=place, capture_output=True, text=True, check=False, timeout=1800)
    if done.returncode:
        raise RunError(f"{shlex.join(command)} failed:\n{done.stdout[-1500:]}{done.stderr[-500:]}")
    return done.stdout


def _run(place: Path, script: str, variables: dict[str, object]) -> float:
    """Runs a script on one rank; processor seconds."""
    before = os.times()
    _finished(_words(script, variables), place)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system
