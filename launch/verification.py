"""Rows of build/verification.json: what a verification test compared, and how long it took.

A test calls record(); `slidewave test --full` names the directory in SLIDEWAVE_VERIFICATION and
collects the rows afterwards. C++ tests may write such files themselves."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path

VARIABLE = "SLIDEWAVE_VERIFICATION"


def record(case: str, quantity: str, value: float, reference: float | None, tolerance: float | None, wall_s: float,
           absolute: bool = False) -> None:
    """Notes one comparison. The error is relative to the reference, or as it is where `absolute`. Without a tolerance
    the value is reported, not held; it may have no reference then."""
    place = os.environ.get(VARIABLE)
    if not place:
        return
    error = None if reference is None else abs(value - reference) / (1.0 if absolute or reference == 0 else abs(reference))
    row = {"case": case, "quantity": quantity, "value": value, "reference": reference, "error": error,
           "tolerance": tolerance, "wall_s": wall_s, "pass": tolerance is None or error <= tolerance}
    name = "".join(c if c.isalnum() else "_" for c in f"{case}-{quantity}")
    Path(place).mkdir(parents=True, exist_ok=True)
    (Path(place) / f"{name}.json").write_text(json.dumps(row))


def collect(place: Path, file: Path) -> list[dict]:
    """Joins the rows below `place` into `file`, sorted by case and quantity."""
    rows = [json.loads(path.read_text()) for path in sorted(place.glob("*.json"))]
    rows.sort(key=lambda r: (r["case"], r["quantity"]))
    file.write_text(json.dumps(rows, indent=1) + "\n")
    return rows


def table(rows: list[dict]) -> str:
    """docs/results/verification.md: rows as a Markdown table."""
    lines = ["# Verification results", "",
             "Made from build/verification.json (`./slidewave test --full`) by `python3 -m launch.verification FILE`.", "",
             "| case | quantity | value | reference | error | tolerance | wall s | pass |",
             "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        reference, error = ("-", "-") if r["reference"] is None else (f"{r['reference']:.6g}", f"{r['error']:.2g}")
        tolerance, verdict = ("-", "reported") if r["tolerance"] is None else (f"{r['tolerance']:g}", "yes" if r["pass"] else "NO")
        lines.append(f"| {r['case']} | {r['quantity']} | {r['value']:.6g} | {reference} | {error} "
                     f"| {tolerance} | {r['wall_s']:.1f} | {verdict} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(table(json.loads(Path(sys.argv[1]).read_text())), end="")
