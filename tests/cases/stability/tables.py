"""The stability map as a small CSV and as the tables of docs/stability.md."""

from __future__ import annotations

import csv
import math
from pathlib import Path

from tests.cases.stability.trial import Outcome

COLUMNS = ("momentum_defect", "momentum_outstanding", "solid_volume_defect", "water_volume_defect")
BEGIN, END = "<!-- stability map: begin -->", "<!-- stability map: end -->"
CAUGHT = 0.8  # share of the refused scenes that must fail or miss the accuracy


def write_csv(path: Path, outcomes: list[Outcome]) -> None:
    """A row a scene."""
    with path.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream, lineterminator="\n")
        table.writerow(["scene", "check", "limiting quantity", "value and limit", "stable", "error", *COLUMNS,
                        "run time s", "what failed"])
        for o in outcomes:
            table.writerow([o.title, o.verdict, o.limiting, o.limit, int(o.stable), _number(o.error),
                            *(_number(o.budgets.get(c, math.nan)) for c in COLUMNS), f"{o.wall_s:.1f}", o.why])


def read_csv(path: Path) -> dict[str, Outcome]:
    """The rows of an earlier map by scene; none where there is no file."""
    if not path.is_file():
        return {}
    with path.open(newline="", encoding="utf-8") as stream:
        rows = list(csv.DictReader(stream))
    return {r["scene"]: Outcome(r["scene"], r["check"], r["limiting quantity"], r["value and limit"], r["stable"] == "1",
                                r["what failed"], float(r["error"] or "nan"),
                                {c: float(r[c]) for c in COLUMNS if r[c]}, float(r["run time s"])) for r in rows}


def confusion(outcomes: list[Outcome]) -> dict[str, tuple[int, int, int]]:
    """By verdict: how many ran well, ran but missed the accuracy, failed."""
    found = {}
    for name, verdicts in (("accepted", ("ok", "warn")), ("refused", ("bad",))):
        rows = [o for o in outcomes if o.verdict in verdicts]
        found[name] = (sum(o.good for o in rows), sum(o.stable and not o.accurate for o in rows),
                       sum(not o.stable for o in rows))
    return found


def faults(outcomes: list[Outcome]) -> list[str]:
    """Where the demands do not hold: accepted scenes that fail, and too many refused ones that run well."""
    found = [f"accepted, and fails: {o.title}: {o.why}" for o in outcomes if o.accepted and not o.stable]
    well, missed, failed = confusion(outcomes)["refused"]
    if missed + failed < CAUGHT * (well + missed + failed):
        found.append(f"{well} of {well + missed + failed} refused scenes run well")
    return found


def markdown(outcomes: list[Outcome]) -> str:
    """Confusion table and a table a group."""
    table = confusion(outcomes)
    text = ["| check | runs well | runs, error above 5 % | fails |", "|---|---|---|---|"]
    text += [f"| {name} | {' | '.join(str(n) for n in table[name])} |" for name in ("accepted", "refused")]
    group = None
    for o in outcomes:
        head, name = o.title.split(": ", 1)
        if head != group:
            group = head
            text += ["", f"**{head}**", "", "| scene | check | limiting number | seen | error | momentum defect | run time s |",
                     "|---|---|---|---|---|---|---|"]
        seen = "stable" if o.stable else f"**{_short(o.why)}**" if o.accepted else _short(o.why)
        defect = o.budgets.get("momentum_defect")
        text.append(f"| {name} | {o.verdict} | {o.limiting} {o.limit} | {seen} | {_per_cent(o.error)} "
                    f"| {'' if defect is None else f'{defect:.0e}'} | {o.wall_s:.1f} |")
    return "\n".join(text) + "\n"


def put_into(path: Path, text: str) -> None:
    """Replaces what stands between the two marks of a page."""
    page = path.read_text(encoding="utf-8")
    start, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    path.write_text(f"{page[:start]}\n{text}{page[end:]}", encoding="utf-8")


def _short(why: str) -> str:
    for mark, words in (("mean-square speed", "blows up"), ("errorcode", "blows up: ends itself"), ("Lost atoms", "blows up: lost"),
                        ("below two of", "cannot be forced")):
        if mark in why:
            return words
    return why.split(": ")[-1][:60] or "fails"


def _number(value: float) -> str:
    return "" if math.isnan(value) else f"{value:.3g}"


def _per_cent(value: float) -> str:
    return "" if math.isnan(value) else f"{100 * value:.2g} %"
