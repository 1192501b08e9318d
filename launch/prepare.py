"""Writes a run directory completely: the two programs then read it alone. No source tree, no Python."""

from __future__ import annotations

import shutil
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from launch import consistency, facts, inputs, parameters, places, progress, ranks, sides, toml_out
from launch.case import Case
from launch.errors import InputError

DECOMPOSE = """// Written by slidewave: scotch of this Debian package is a dummy, simple works.
FoamFile {{ version 2.0; format ascii; class dictionary; object decomposeParDict; }}
numberOfSubdomains {ranks};
method simple;
simpleCoeffs {{ n ({n[0]} {n[1]} {n[2]}); delta 0.001; }}
"""


@dataclass
class Prepared:
    """A complete run directory, its facts, ranks of both sides, time it took [s], engine of each side."""

    directory: Path
    facts: facts.Facts
    ranks_fluid: int
    ranks_dem: int
    prepare_s: float
    fluid_engine: str = "openfoam"
    dem_engine: str = "liggghts"


def terrain_hook(case: Case):
    """launch.terrain where the case has a [geometry] table, else None."""
    if case.get("geometry") is None:
        return None
    from launch import terrain

    return terrain


def check_input(case: Case) -> None:
    """Everything that can be refused before a file is written."""
    consistency.check(case)
    hook = terrain_hook(case)
    inputs.check_inputs(case, set(getattr(hook, "PARAMETERS", ())))


def prepare(case: Case, directory: Path, ranks_fluid: int | None = None,
            ranks_dem: int | None = None) -> Prepared:
    """Fills an empty directory from a checked case. RunError where a utility fails."""
    start = time.monotonic()
    fluid = directory / "fluid" if case.get("fluid.engine") == "openfoam" else None
    dem = directory / "dem" if case.get("dem.engine") != "none" else None
    for side in filter(None, (fluid, dem)):
        shutil.copytree(case.directory / side.name, side)
    parameters.write(case, fluid, dem)
    hook = terrain_hook(case)
    if hook is not None:
        hook.prepare(case, directory, progress.say)
        parameters.write(case, fluid, dem)
    if fluid:
        _mesh(fluid, directory)
    known = facts.gather(case, directory)
    sides.check(case, known)
    _fill_kernel(case, known)
    if fluid:
        fluid_ranks = ranks_fluid or ranks.suggested(known.mesh.cells, ranks.CELLS_A_RANK)
        decompose(fluid, directory, known.mesh, fluid_ranks)
        (fluid / "case.foam").touch()
    else:  # a prescribed flow is one rank's work
        fluid_ranks = 0 if case.get("fluid.engine") == "none" else ranks_fluid or 1
    dem_ranks = _dem_ranks(case, known, ranks_dem) if dem else 0
    ready = Prepared(directory, known, fluid_ranks, dem_ranks, 0.0, case.get("fluid.engine"),
                     case.get("dem.engine"))
    _choose(case, ready)
    write_case(case, directory, fluid_ranks, dem_ranks)
    ready.prepare_s = time.monotonic() - start
    return ready


def _choose(case: Case, ready: Prepared) -> None:
    from launch import regime, scheme  # which need Prepared

    regime.choose(case, ready)
    scheme.choose(case, ready)


def _dem_ranks(case: Case, known: facts.Facts, wanted: int | None) -> int:
    fixed = ranks.FIXED_DEM_RANKS.get(case.get("dem.engine"))
    if fixed and wanted not in (None, fixed):
        raise InputError("--ranks-dem", "ranks", wanted, f"dem.engine = \"{case.get('dem.engine')}\" takes "
                         f"{fixed}: a master and one worker")
    return fixed or wanted or ranks.suggested(known.particles or 0, ranks.PARTICLES_A_RANK)


def write_case(case: Case, directory: Path, ranks_fluid: int, ranks_dem: int) -> None:
    """DIR/case.toml: the resolved case with its [run] table."""
    run = {"variant": case.variant, "ranks_fluid": ranks_fluid, "ranks_dem": ranks_dem,
           "version": places.version(), "source": str(case.directory)}
    head = "# Resolved by slidewave; both programs read this file.\n"
    (directory / "case.toml").write_text(head + toml_out.dumps(case.data | {"run": run}))


def _mesh(fluid: Path, directory: Path) -> None:
    environment = places.openfoam_environment()
    for name in ("blockMesh", "setFields"):
        if name == "blockMesh" and (fluid / "constant/polyMesh/points").exists():
            continue
        if (fluid / "system" / f"{name}Dict").is_file():
            progress.utility([name, "-case", str(fluid)], directory / f"log.{name}", environment, directory)


def decompose(fluid: Path, directory: Path, mesh: facts.MeshFacts, count: int) -> None:
    """Cuts the mesh and the initial fields along its longest extent; nothing for one rank."""
    if count <= 1:
        return
    if count > mesh.cells:
        raise InputError("--ranks-fluid", "ranks", count, f"more than cells ({mesh.cells})")
    pieces = [1, 1, 1]
    pieces[int(np.argmax(mesh.box[1] - mesh.box[0]))] = count
    (fluid / "system/decomposeParDict").write_text(DECOMPOSE.format(ranks=count, n=pieces))
    progress.utility(["decomposePar", "-case", str(fluid)], directory / "log.decomposePar",
                     places.openfoam_environment(), directory)


def _fill_kernel(case: Case, known: facts.Facts) -> None:
    """Length of the kernel, max(1.5 D_max, 1.5 cell size) [m], and its deposit, where the case gives
    none and the particles act on the fluid."""
    if case.get("coupling.reaction") != "two_way" or known.mesh is None:
        return
    if case.get("coupling.smoothing_length") is None:
        length = 1.5 * max(known.largest_diameter_m or 0.0, known.mesh.cell_size_m)
        case.put("coupling.smoothing_length", float(f"{length:.6g}"))
    if case.get("coupling.deposit") is None:
        diameter = known.largest_diameter_m
        small = diameter is not None and diameter <= known.mesh.cell_size_m / 4
        case.put("coupling.deposit", "centroid" if small else "spline")
