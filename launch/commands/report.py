"""Rebuilds report.html (self-contained) and the targets in summary.json of a run directory."""

from __future__ import annotations

import argparse
import signal
from pathlib import Path

from launch import places, process, results
from launch.case import read_toml
from launch.errors import InputError
from launch.progress import say

NAME = "report"
HELP = "rebuild the report of a run"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `report`."""
    parser.add_argument("directory", metavar="DIR", type=Path, help="run directory")


def main(options: argparse.Namespace) -> int:
    """Runs the command."""
    directory = options.directory
    if not (directory / "case.toml").is_file():
        raise InputError(directory, "DIR", None, "holds no run: it has no case.toml")
    if not (directory / "history.csv").is_file():
        raise InputError(directory, "DIR", None, "holds no result: it has no history.csv; run it first")
    finish(directory, {}, None)
    build(directory)
    return 0


def finish(directory: Path, extra: dict, status: int | None) -> dict:
    """Completes summary.json: what the programs wrote, `extra`, targets and quantities. `status` is
    mpirun's exit status, None where it is not known (then the status stays)."""
    case = read_toml(directory / "case.toml")
    summary = results.read_summary(directory)
    run = case.get("run", {})
    summary.setdefault("case", case.get("case", {}).get("name", ""))
    summary.setdefault("variant", run.get("variant", ""))
    summary.setdefault("version", run.get("version", places.version()))
    summary.setdefault("ranks", {"fluid": run.get("ranks_fluid"), "dem": run.get("ranks_dem")})
    failure = directory / "failure.txt"
    if status or (status is None and "status" not in summary):
        summary["status"] = "failed"
        summary["reason"] = (failure.read_text().strip() if failure.is_file()
                             else ending(status))
    summary.setdefault("status", "completed")
    history = results.read_history(directory)
    summary["quantities"] = results.quantities(history)
    summary["targets"] = [results.judge(t, history) for t in case.get("target", [])
                          if results.applies(t, case)]
    summary |= extra
    results.write_summary(directory, summary)
    return summary


def ending(status: int | None) -> str:
    """How the programs ended, where they could not tell: in words."""
    if status is None or not 128 < status < 128 + signal.NSIG:
        return f"the programs ended with status {status}"
    name = signal.Signals(status - 128).name
    why = " (by hand, or by the system for lack of memory)" if name == "SIGKILL" else ""
    return f"a program was ended by {name}{why}"


def build(directory: Path) -> None:
    """Writes report.html."""
    from launch import report_page  # matplotlib takes half a second: only where a page is written

    report_page.write(directory, read_toml(directory / "case.toml"), results.read_summary(directory))
    say(f"report: {directory / 'report.html'}")


def conclude(directory: Path, status: int, clock: process.Clock) -> int:
    """Prints how the run ended and its targets; gives the exit status of the command."""
    summary = results.read_summary(directory)
    summary["total_s"] = clock.elapsed_s()
    results.write_summary(directory, summary)
    missed = [t["name"] for t in summary["targets"] if t["required"] and not t["pass"]]
    for target in summary["targets"]:
        value = "no value" if target["value"] is None else f"{target['value']:.5g}"
        verdict = "pass" if target["pass"] else "MISS"
        say(f"  {verdict}  {target['name']}: {value} {target['unit']} "
            f"(reference {target['reference']:g})")
    say(f"{summary['status']} in {summary['total_s']:.1f} s: {directory}")
    if summary.get("reason"):
        say(f"reason: {summary['reason']}")
    if status == 2:
        return 2
    if status == 0 and missed:
        say(f"required targets missed: {', '.join(missed)}")
    return 1 if status or missed else 0
