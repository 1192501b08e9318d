"""bench fluid: a fluid step without particles, ours over interFoam (two fluids) and pimpleFoam (one).

The same case, mesh, step and solver settings on one rank, in alternation. Processor time; the difference
of a long and a short run, so that the start is not counted."""

from __future__ import annotations

import argparse
import statistics
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from launch import case as cases
from launch import places, prepare, rank_usage, ranks, results
from launch.errors import RunError
from launch.progress import say


@dataclass(frozen=True)
class Scene:
    """A case, what is changed in it, the step [s], and the solver that ours must be like."""

    case: str
    settings: tuple[str, ...]
    step_s: float
    solver: str


SCENES = {
    "two_fluids": Scene("verification/standing_wave", ("parameters.cells_x=120", "parameters.cells_z=120",
                                                       "parameters.fluid_dt=0.002"), 0.002, "interFoam"),
    "one_fluid": Scene("benchmark_bed", ("dem.engine=none", "coupling.reaction=one_way",
                                         "parameters.cells=24", "coupling.window=1e-3"), 1e-3, "pimpleFoam"),
}
SHORT, LONG = 20, 120  # steps


def measure(options: argparse.Namespace) -> dict[str, object]:
    """All numbers of DESIGN.md 9, and the processor seconds a step behind them."""
    numbers: dict[str, object] = {}
    for name in SCENES:
        numbers |= compare(name, options.repeats)
    return numbers


def compare(name: str, repeats: int, steps: tuple[int, int] = (SHORT, LONG),
            settings: tuple[str, ...] = ()) -> dict[str, float]:
    """Ratio and costs of one scene; `settings` come after the scene's own."""
    scene = SCENES[name]
    spent: dict[str, list[float]] = {"own": [], scene.solver: []}
    with tempfile.TemporaryDirectory(prefix="slidewave-bench-") as place:
        ready = {n: _prepare(scene, settings, n, Path(place).resolve() / str(n)) for n in steps}
        for number in range(repeats):
            for program, run in (("own", _own), (scene.solver, _solver)):
                short, long = (run(scene, ready[n], n) for n in steps)
                spent[program].append((long - short) / (steps[1] - steps[0]))
            say(f"{name}, pair {number + 1}: own {spent['own'][-1] * 1e3:.3f}, "
                f"{scene.solver} {spent[scene.solver][-1] * 1e3:.3f} ms a step")
    ratios = [own / other for own, other in zip(spent["own"], spent[scene.solver])]
    return {f"ratio_{name}": statistics.median(ratios),
            f"{name}_own_s": statistics.median(spent["own"]),
            f"{name}_{scene.solver}_s": statistics.median(spent[scene.solver])}


def _prepare(scene: Scene, settings: tuple[str, ...], steps: int, place: Path) -> prepare.Prepared:
    case = cases.load(scene.case, None, [*scene.settings, *settings])
    window = case.get("coupling.window")
    case.put("case.end_time", max(1, round(steps * scene.step_s / window)) * window)
    case.put("output.interval", case.get("case.end_time"))
    prepare.check_input(case)
    place.mkdir()
    ready = prepare.prepare(case, place, 1, None)
    with (place / "fluid/system/controlDict").open("a") as control:  # interFoam wants them, unused or not
        control.write("\nmaxCo 1;\nmaxAlphaCo 1;\nmaxDeltaT 1;\n")
    return ready


def _own(scene: Scene, ready: prepare.Prepared, steps: int) -> float:
    words = ranks.mpirun_words(ready.directory, 1, 0, ready.fluid_engine, ready.dem_engine)
    spent = _run(rank_usage.wrapped(words, ready.directory / "usage"), ready.directory)
    taken = results.read_history(ready.directory)["fluid_steps"][-1]
    if taken != steps:
        raise RunError(f"{scene.case}: {taken:g} steps, not {steps}: the comparison does not hold")
    return spent


def _solver(scene: Scene, ready: prepare.Prepared, _steps: int) -> float:
    words = [*rank_usage.WRAPPER, str(ready.directory / "usage"), scene.solver, "-case",
             str(ready.directory / "fluid")]
    return _run(words, ready.directory)


def _run(words: list[str], directory: Path) -> float:
    done = subprocess.run(words, env=rank_usage.environment(), capture_output=True, text=True, check=False,
                          timeout=1800)
    if done.returncode:
        raise RunError(f"{words[-1]} failed:\n{done.stdout[-1500:]}{done.stderr[-500:]}")
    return rank_usage.read(directory / "usage")[0]["processor_s"]
