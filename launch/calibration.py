"""Speed of both engines on this machine, for the core time that `check` expects: processor time of a small
bed and of a sloshing tank, start-up taken off. Measured once for each build, kept in .cache."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

from launch import case as cases
from launch import places, prepare, ranks
from launch.errors import InputError, RunError

SPHERES, STEPS, WINDOWS = 4000, 300, 40
PACKAGED = """fix kn all property/global kn peratomtypepair 1 3e9
fix kt all property/global kt peratomtypepair 1 2.7e9
fix gn all property/global gamman peratomtypepair 1 0
fix gt all property/global gammat peratomtypepair 1 0
fix mu all property/global coefficientFriction peratomtypepair 1 0.577
pair_style gran model hooke/stiffness tangential history
"""
OWN = "pair_style gran model linear tangential coulomb kn 3e9 ks 2.7e9 mu 0.577\n"
# A face-centred lattice of spheres that press on each other, displaced at random.
BED = """units si
atom_style granular
atom_modify map array
boundary p p p
newton off
communicate single vel yes
region box block 0 40 0 40 0 40 units box
create_box 1 box
neighbor 0.4 bin
neigh_modify delay 0
{law}pair_coeff * *
lattice fcc 4 origin 0.25 0.25 0.25
create_atoms 1 region box
set group all diameter 2.85 density 2650
displace_atoms all random 0.02 0.02 0.02 15485863 units box
fix motion all nve/sphere
timestep 4e-4
run {steps}
"""
TANK = "verification/standing_wave"


def unit_costs(own_law: bool, measure: bool) -> dict[str, float]:
    """particle_steps_per_s and cell_steps_per_s of one core, as far as known; measured now where `measure`
    and not yet known (seconds). Engines that are not built are left out."""
    known = _read()
    wanted = {"particle_steps_per_s": "own law" if own_law else "packaged law",
              "cell_steps_per_s": "fluid"}
    if measure and any(name not in known for name in wanted.values()):
        known |= {name: speed for name in wanted.values()
                  if name not in known and (speed := _measured(name)) is not None}
        _write(known)
    return {fact: known[name] for fact, name in wanted.items() if name in known}


def _measured(name: str) -> float | None:
    """Particle-steps or cell-steps a second of processor time, None where the programs do not run."""
    try:
        return _fluid_speed() if name == "fluid" else _bed_speed(OWN if name == "own law" else PACKAGED)
    except (InputError, OSError, RunError, subprocess.SubprocessError):
        return None


def _bed_speed(law: str) -> float:
    spent = []
    with tempfile.TemporaryDirectory(prefix="slidewave-calibration-") as place:
        for steps in (0, STEPS):
            (Path(place) / "bed.in").write_text(BED.format(law=law, steps=steps))
            spent.append(_processor_s([str(places.program("slidewave_dem")), "--script", "bed.in", "-log", "none"],
                                      place))
    return SPHERES * STEPS / max(spent[1] - spent[0], 1e-3)


def _fluid_speed() -> float:
    spent, steps, cells = [], [], 0
    for windows in (1, 1 + WINDOWS):
        case = cases.load(TANK)
        case.data.pop("output", None)
        case.put("case.end_time", windows * case.get("coupling.window"))
        with tempfile.TemporaryDirectory(prefix="slidewave-calibration-") as place:
            ready = prepare.prepare(case, Path(place).resolve() / "run", 1)
            words = ranks.mpirun_words(ready.directory, 1, 0, "openfoam")
            spent.append(_processor_s(words[-2:], place))
            steps.append(windows * case.get("coupling.window") / case.get("parameters.fluid_dt"))
            cells = ready.facts.mesh.cells
    return cells * (steps[1] - steps[0]) / max(spent[1] - spent[0], 1e-3)


def _processor_s(words: list[str], place: str) -> float:
    before = os.times()
    subprocess.run(words, cwd=place, env=places.openfoam_environment(), capture_output=True, check=True, timeout=60)
    after = os.times()
    return after.children_user + after.children_system - before.children_user - before.children_system


def _file() -> Path:
    return places.cache_dir() / "calibration.json"


def _builds() -> dict[str, list[int]]:
    """What tells one build from another."""
    found = [places.program(name) for name in ("slidewave_dem", "slidewave_foam")]
    return {path.name: [path.stat().st_mtime_ns, path.stat().st_size] for path in found if path.is_file()}


def _read() -> dict[str, float]:
    try:
        kept = json.loads(_file().read_text())
    except (OSError, json.JSONDecodeError):
        return {}
    return kept["speeds"] if kept.get("builds") == _builds() else {}


def _write(speeds: dict[str, float]) -> None:
    _file().parent.mkdir(parents=True, exist_ok=True)
    new = _file().with_suffix(f".{os.getpid()}")
    new.write_text(json.dumps({"builds": _builds(), "speeds": speeds}, indent=1) + "\n")
    new.replace(_file())
