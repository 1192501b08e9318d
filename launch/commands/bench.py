"""Measures unit costs on this machine, from paired runs: what we compare with and ours in alternation.

dem: our contact law against the packaged one, on a settled bed of 25,000 spheres and on the moving
slide of vajont_east. Ratios are of processor time; the trajectories of both are compared too.
"""

from __future__ import annotations

import argparse
import importlib
import json
from pathlib import Path

from launch.errors import InputError

NAME = "bench"
HELP = "unit costs from paired runs: dem"
BENCHES = {"dem": "launch.bench_dem"}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `bench`."""
    parser.add_argument("what", choices=sorted(BENCHES), help="what to measure")
    parser.add_argument("--json", metavar="FILE", help="the numbers as JSON too")
    parser.add_argument("--repeats", metavar="N", type=int, default=3, help="pairs of runs (default 3)")
    parser.add_argument("--size", metavar="N", type=int, help="spheres of the bed (default 25000)")


def main(options: argparse.Namespace) -> int:
    """Runs the command."""
    if options.repeats < 1:
        raise InputError("command line", "--repeats", options.repeats, "give a number from 1")
    numbers = importlib.import_module(BENCHES[options.what]).measure(options)
    if options.json:
        Path(options.json).write_text(json.dumps(numbers, indent=1) + "\n")
    for name, value in numbers.items():
        print(f"{name:<34} {value:.4g}" if isinstance(value, float) else f"{name:<34} {value}")
    return 0
