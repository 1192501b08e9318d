"""Measures unit costs on this machine, from paired runs: what we compare with and ours in alternation.

dem: our contact law against the packaged one, on a settled bed of 25,000 spheres and on the moving
slide of vajont_east. Ratios are of processor time; the trajectories of both are compared too.
fluid: a fluid step without particles against interFoam's (two fluids) and pimpleFoam's (one).
coupling: exchange, location, void fraction and forces per particle and window on cases/benchmark_bed.
"""

from __future__ import annotations

import argparse
import importlib
import json
from pathlib import Path

from launch.errors import InputError

NAME = "bench"
HELP = "unit costs from paired runs: dem, fluid, coupling"
BENCHES = {"coupling": "launch.bench_coupling", "dem": "launch.bench_dem", "fluid": "launch.bench_fluid"}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `bench`."""
    parser.add_argument("what", choices=sorted(BENCHES), help="what to measure")
    parser.add_argument("--json", metavar="FILE", help="the numbers as JSON too")
    parser.add_argument("--repeats", metavar="N", type=int, default=3, help="pairs of runs (default 3)")
    parser.add_argument("--size", metavar="N", type=int, help="dem: spheres of the bed (default 25000)")
    parser.add_argument("--large", action="store_true", help="coupling: 5e5 and 1e6 particles too")


def main(options: argparse.Namespace) -> int:
    """Runs the command."""
    if options.repeats < 1:
        raise InputError("command line", "--repeats", options.repeats, "give a number from 1")
    numbers = importlib.import_module(BENCHES[options.what]).measure(options)
    if options.json:
        Path(options.json).write_text(json.dumps(numbers, indent=1) + "\n")
    for row in numbers.pop("rows", []):
        print("  ".join(f"{name} {value:.4g}" for name, value in row.items()))
    for name, value in numbers.items():
        print(f"{name:<34} {value:.4g}" if isinstance(value, float) else f"{name:<34} {value}")
    return 0
