"""Reads the command line and calls the command. A command is one module in launch/commands with
NAME, HELP, arguments(parser) and main(options); adding one means adding it to COMMANDS.

Exit status: 0 done, 1 ran or would run badly, 2 bad input.
"""

from __future__ import annotations

import argparse
import sys

from launch import __version__
from launch.commands import bench, check, report, run, study, submit, test
from launch.errors import InputError, RunError

COMMANDS = (run, check, report, study, bench, submit, test)

EPILOG = """exit status: 0 done; 1 ran or would run badly; 2 bad input

first steps:
  slidewave run cases/settling_sphere        seconds
  slidewave run cases/vajont_east            minutes; then open runs/vajont_east-quick/report.html
  slidewave setup --list                     packages needed, and which are missing
"""


def parser() -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser(
        prog="slidewave",
        description="Couples OpenFOAM (water, air) and LIGGGHTS (rock) in one mpirun.",
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    top.add_argument("--version", action="version", version=__version__)
    commands = top.add_subparsers(metavar="COMMAND", required=True)
    setup = "install missing packages, get OpenFOAM's headers, build (--list: only tell)"
    commands.add_parser("setup", help=setup)
    for module in COMMANDS:
        sub = commands.add_parser(module.NAME, help=module.HELP, description=module.__doc__,
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
        module.arguments(sub)
        sub.set_defaults(main=module.main)
    return top


def main(arguments: list[str]) -> int:
    """Runs one command and gives the exit status."""
    if not arguments:
        parser().print_help()
        return 2
    options = parser().parse_args(arguments)
    try:
        return options.main(options)
    except InputError as error:
        print(f"slidewave: {error}", file=sys.stderr)
        return 2
    except RunError as error:
        print(f"slidewave: {error}", file=sys.stderr)
        return 1
