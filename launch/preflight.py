"""The pre-flight check: numbers of a prepared scene against the limits of the C++ tool
slidewave_preflight, which holds the same functions that the programs use."""

from __future__ import annotations

import json
import subprocess
from dataclasses import asdict, dataclass

from launch import calibration, scene_numbers
from launch.case import Case
from launch.errors import RunError
from launch.places import program
from launch.prepare import Prepared


@dataclass
class Finding:
    """One row: quantity, value, limit, verdict (ok, warn, bad, note: for information), source of the limit, key to
    change, value that works, margin: how far the value may still grow (or fall) to reach the limit."""

    quantity: str
    value: float | str | None
    limit: float | str | None
    verdict: str
    source: str = ""
    key: str = ""
    works: float | str | None = None
    margin: float | None = None

    @property
    def bad(self) -> bool:
        return self.verdict == "bad"

# What the tool calls a key, and what cases call it, best first; the last where the case has none of them.
OWN_KEYS = {
    "parameters.kn": ("parameters.kn", "parameters.contact_stiffness", "kn of the contact law"),
    "parameters.particle_density": ("parameters.particle_density", "parameters.solid_density",
                                    "density of the particles"),
    "parameters.cell": ("parameters.cell", "geometry.cell_size", "cell size of the mesh"),
    "parameters.fluid_dt": ("parameters.fluid_dt", "coupling.window"),
    "parameters.width": ("parameters.width", "periodic width of the box"),
}


def examine(case: Case, ready: Prepared, calibrate: bool = False) -> list[Finding]:
    """All findings about a prepared scene; with `calibrate` the engines' speed on this machine is measured
    where it is not known yet (seconds)."""
    costs = calibration.unit_costs(ready.facts.dem.own_law, calibrate)
    rows = own_findings(ready) + tool_findings(scene_numbers.collect(case, ready) | costs)
    for row in rows:
        names = OWN_KEYS.get(row.key)
        if names:
            row.key = next((name for name in names if case.get(name) is not None), names[-1])
    return rows


def own_findings(ready: Prepared) -> list[Finding]:
    """Sizes of the scene, for the reader."""
    rows = [Finding("ranks, fluid + particles", f"{ready.ranks_fluid} + {ready.ranks_dem}", None, "note")]
    particles = ready.facts.particles
    rows.append(Finding("particles", "known at start" if particles is None else particles, None, "note"))
    if ready.facts.mesh is not None:
        rows.append(Finding("cells", ready.facts.mesh.cells, None, "note"))
        rows.append(Finding("cell size [m]", ready.facts.mesh.cell_size_m, None, "note"))
    return rows


def tool_findings(numbers: dict) -> list[Finding]:
    """Verdicts of slidewave_preflight on the numbers of a scene; none where it is not built."""
    tool = program("slidewave_preflight")
    if not tool.is_file():
        return []
    try:
        done = subprocess.run([str(tool)], input=json.dumps(numbers), capture_output=True, text=True,
                              timeout=60, check=False)
        rows = json.loads(done.stdout)
    except (subprocess.TimeoutExpired, json.JSONDecodeError) as error:
        raise RunError(f"slidewave_preflight gave no answer: {error}") from error
    return [Finding(**row) for row in rows]


def lines(findings: list[Finding]) -> list[str]:
    """The findings as a table; a bad one is followed by the key to change and a value that works."""
    rows = [f"{'':<5} {'quantity':<50} {'value':>12} {'limit':>10} {'margin':>9}  source of the limit"]
    for f in findings:
        margin = "" if f.margin is None else f"{f.margin:.2g}x"
        rows.append(f"{f.verdict:<5} {f.quantity:<50} {_text(f.value):>12} {_text(f.limit):>10} {margin:>9}  "
                    f"{f.source}".rstrip())
        if f.verdict in ("bad", "warn") and f.key:
            works = "" if f.works is None else f" = {_text(f.works)}"
            rows.append(f"      change {f.key}{works}")
    return rows


def as_json(findings: list[Finding]) -> str:
    """The findings as a JSON list."""
    return json.dumps([asdict(f) for f in findings], indent=1)


def _text(value: float | str | None) -> str:
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)
