"""Checks a case before a core-hour is spent: input, sides, and every stability number.

Prepares the case in a temporary directory (the particles' preparation is cached). The engines are started
once for each build, for seconds, to calibrate the expected core time.
Exit status 0 where the scene is sound, 1 where it would run badly (key and working value named),
2 where the input is refused.
"""

from __future__ import annotations

import argparse
import contextlib
import sys
import tempfile
from pathlib import Path

from launch import case as cases
from launch import preflight, prepare
from launch.commands.run import positive

NAME = "check"
HELP = "pre-flight: input, both sides, stability and accuracy numbers"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `check`."""
    parser.add_argument("case", metavar="CASE", help="directory with a case.toml, or a name below cases/")
    parser.add_argument("--variant", metavar="V", help="variant of the case (default: the case's own)")
    parser.add_argument("--set", metavar="KEY=VALUE", action="append", default=[], dest="settings",
                        help="change any key (repeatable)")
    parser.add_argument("--ranks-fluid", metavar="N", type=positive, help="ranks of the fluid side")
    parser.add_argument("--ranks-dem", metavar="N", type=positive, help="ranks of the particle side")
    parser.add_argument("--json", action="store_true", help="the findings as JSON on standard output")


def main(options: argparse.Namespace) -> int:
    """Runs the command."""
    case = cases.load(options.case, options.variant, options.settings)
    prepare.check_input(case)
    with tempfile.TemporaryDirectory(prefix="slidewave-check-") as place:
        quiet = contextlib.redirect_stdout(sys.stderr) if options.json else contextlib.nullcontext()
        with quiet:
            ready = prepare.prepare(case, Path(place).resolve(), options.ranks_fluid, options.ranks_dem)
            findings = preflight.examine(case, ready, calibrate=True)
    bad = any(f.bad for f in findings)
    if options.json:
        print(preflight.as_json(findings))
    else:
        print("\n".join(preflight.lines(findings)))
        print("would run badly: see the bad rows" if bad else "sound")
    return 1 if bad else 0
