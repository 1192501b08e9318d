"""A case on several decompositions: runs that record what the particles receive, and how far two of them differ.

Needs tests/record_dem of the build."""

from __future__ import annotations

import functools
import re
import subprocess
from collections.abc import Callable
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from launch import cli, foam_file, foam_mesh, places, progress, ranks
from launch import prepare as launch_prepare

COLUMNS = 12  # of record_dem.cpp
WINDOW, RADIUS, POSITION, DRAG = 0, 1, slice(2, 5), 5
VELOCITY, FORCE = slice(6, 9), slice(9, 12)
START, LATER = "at the start", "in the windows"


def prepare(case: Path, folder: Path, fluid: int, dem: int, *words: str) -> None:
    """Writes a run directory for `fluid` and `dem` ranks, without running it."""
    status = cli.main(["run", str(case), "--out", str(folder), "--ranks-fluid", str(fluid), "--ranks-dem", str(dem),
                       "--dry-run", *words])
    assert status == 0


def cut_fluid(folder: Path, axis: int) -> None:
    """Divides the mesh of a run directory for several fluid ranks anew, across `axis`."""
    count = len(foam_mesh.parts(folder / "fluid"))
    pieces = [count if k == axis else 1 for k in range(3)]
    (folder / "fluid/system/decomposeParDict").write_text(launch_prepare.DECOMPOSE.format(ranks=count, n=pieces))
    progress.utility(["decomposePar", "-force", "-case", str(folder / "fluid")], folder / "log.decomposePar",
                     places.openfoam_environment(), folder)


def cut_particles(folder: Path, grid: str) -> None:
    """Has LIGGGHTS deal its box out to ranks by `grid`, e.g. "1 1 2", not by the longest extent."""
    script = folder / "dem/in.setup"
    script.write_text(script.read_text().replace("newton ", f"processors {grid}\nnewton ", 1))


def tighten(folder: Path, tolerance: float) -> None:
    """Every linear solver of a run directory stops at a residual of `tolerance`, however good its first guess."""
    solution = folder / "fluid/system/fvSolution"
    if not solution.is_file():
        return
    text = re.sub(r"\btolerance\s+[^;]+;", f"tolerance {tolerance};", solution.read_text())
    solution.write_text(re.sub(r"\brelTol\s+[^;]+;", "relTol 0;", text))


def run(folder: Path, fluid: int, dem: int, fluid_engine: str = "openfoam", timeout_s: float = 400) -> None:
    """Runs a prepared directory, the particles' answers recorded; `dem` 0: no particles."""
    line = ranks.mpirun_words(folder, fluid, dem, fluid_engine)
    recorder = str(places.build_dir() / "tests" / "record_dem")
    words = [recorder if Path(w).name == "slidewave_dem" else w for w in line]
    subprocess.run(words, env=places.openfoam_environment(), check=True, timeout=timeout_s)


def all_have_particles(folder: Path) -> bool:
    """Whether every DEM rank answered for some, unless there is but one particle."""
    sizes = [file.stat().st_size for file in folder.glob("answers_*.bin")]
    return min(sizes) > 0 or len(np.unique(answers(folder)[:, WINDOW])) == sum(sizes) // (8 * COLUMNS)


def answers(folder: Path) -> np.ndarray:
    """Rows of all ranks, (n, 12); see record_dem.cpp."""
    files = sorted(folder.glob("answers_*.bin"))
    return np.concatenate([np.fromfile(f).reshape(-1, COLUMNS) for f in files])


@functools.cache
def cells_of(part: Path) -> np.ndarray:
    """Places of the cells of one rank's part, or of an undivided mesh, in the undivided mesh."""
    mesh = part / "constant/polyMesh"
    if part.name.startswith("processor"):
        return foam_file.read_labels(mesh / "cellProcAddressing")
    return np.arange(foam_file.read_labels(mesh / "owner").max() + 1)


def field(folder: Path, number: int, name: str) -> np.ndarray:
    """A field of the stored time `number` in the order of the undivided mesh, (cells,) or (cells, 3)."""
    time = foam_mesh.times(folder / "fluid")[number][1]
    parts = foam_mesh.parts(folder / "fluid")
    pieces = [foam_file.read_field(part / time / name, cells_of(part).size) for part in parts]
    whole = np.empty((sum(map(len, pieces)), *pieces[0].shape[1:]))
    whole[np.concatenate([cells_of(part) for part in parts])] = np.concatenate(pieces)
    return whole


def matched(one: np.ndarray, other: np.ndarray, window: int) -> tuple[np.ndarray, np.ndarray]:
    """Rows of a window, the same particle in the same row."""
    a, b = (rows[rows[:, WINDOW] == window] for rows in (one, other))
    distance, where = cKDTree(b[:, POSITION]).query(a[:, POSITION])
    same = len(a) == len(b) == len(np.unique(where)) and np.all(distance < 1e-2 * a[:, RADIUS])
    assert same, f"window {window}: {len(a)} and {len(b)} particles, up to {distance.max():.2g} m apart"
    return a, b[where]


def worst(reference: Path, other: Path, windows: int, velocity: float, force: float) -> dict[tuple[str, str], float]:
    """Largest difference of what the particles received, by quantity and stage (START, LATER). u_f is compared with
    `velocity`, F with `force`, K with the window's mean: a particle's own follows a slip that may be next to nothing."""
    one, two = answers(reference), answers(other)
    found: dict[tuple[str, str], float] = {}
    for window in range(windows + 1):
        a, b = matched(one, two, window)
        stage = LATER if window else START
        for quantity, columns, scale in (("K", DRAG, a[:, DRAG].mean()), ("u_f", VELOCITY, velocity), ("F", FORCE, force)):
            error = np.abs(b[:, columns] - a[:, columns]).max() / (scale or 1.0)
            found[quantity, stage] = max(found.get((quantity, stage), 0.0), float(error))
    return found


def worst_stored(reference: Path, other: Path, windows: int,
                 value: Callable[[Path, int], np.ndarray]) -> dict[str, float]:
    """Largest difference of what `value` makes of the fields stored at a time, over its largest in the reference, by
    stage."""
    found, scale = {START: 0.0, LATER: 0.0}, 0.0
    for window in range(windows + 1):
        a, b = value(reference, window), value(other, window)
        scale = max(scale, float(np.abs(a).max()))
        stage = LATER if window else START
        found[stage] = max(found[stage], float(np.abs(b - a).max()))
    return {stage: error / scale for stage, error in found.items()}


def void_fraction(folder: Path, number: int) -> np.ndarray:
    return field(folder, number, "eps")
