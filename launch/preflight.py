"""The pre-flight check: numbers of a prepared scene against the limits of the C++ tool
slidewave_preflight, which holds the same functions that the programs use."""

from __future__ import annotations

import json
import subprocess
from dataclasses import asdict, dataclass

from launch import scene_numbers
from launch.case import Case
from launch.errors import RunError
from launch.places import program
from launch.prepare import Prepared


@dataclass
class Finding:
    """One row: quantity, value, limit, verdict (ok, warn, bad, note, "" for information), source, key to change, value that works."""

    quantity: str
    value: float | str | None
    limit: float | str | None
    verdict: str
    source: str = ""
    key: str = ""
    works: float | str | None = None

    @property
    def bad(self) -> bool:
        return self.verdict == "bad"


def examine(case: Case, ready: Prepared) -> list[Finding]:
    """All findings about a prepared scene."""
    return own_findings(ready) + tool_findings(scene_numbers.collect(case, ready))


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
    rows = []
    for f in findings:
        limit = "" if f.limit is None else f"limit {_text(f.limit)}"
        rows.append(f"{f.verdict:<5} {f.quantity:<44} {_text(f.value):>12}  {limit:<20} {f.source}".rstrip())
        if f.verdict in ("bad", "warn") and f.key:
            works = "" if f.works is None else f" = {_text(f.works)}"
            rows.append(f"      change {f.key}{works}")
    return rows


def as_json(findings: list[Finding]) -> str:
    """The findings as a JSON list."""
    return json.dumps([asdict(f) for f in findings], indent=1)


def _text(value: float | str | None) -> str:
    return f"{value:.4g}" if isinstance(value, float) else "" if value is None else str(value)
