"""Builds (the bootstrap did), checks our own sources (format, lint, sanitizers), runs the tests with
ctest.

--full runs the slow verification and clang-tidy's static analyzer too and writes
build/verification.json, a row a comparison.
ctest's own summary closes the output.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import time

from launch import code_checks, places, verification
from launch.errors import RunError
from launch.progress import say

NAME = "test"
HELP = "build and pass the tests"
STAGES = {"format": lambda full: code_checks.format_is_right(), "lint": code_checks.lint,
          "sanitizers": lambda full: code_checks.under_sanitizers()}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `test`."""
    parser.add_argument("--full", action="store_true", help="slow verification too (label full)")


def main(options: argparse.Namespace) -> int:
    """Runs the command; exit status 1 where a test fails."""
    for name, stage in STAGES.items():
        start = time.monotonic()
        stage(options.full)
        say(f"stage {name}: {time.monotonic() - start:.1f} s")
    start = time.monotonic()
    words = ["ctest", "--test-dir", str(places.build_dir()), "-j4", "--output-on-failure"]
    environment = dict(os.environ)
    rows = places.build_dir() / "verification"
    if options.full:
        shutil.rmtree(rows, ignore_errors=True)
        environment[verification.VARIABLE] = str(rows)
    else:
        words += ["-LE", "full"]
    status = subprocess.run(words, env=environment, check=False).returncode
    if options.full:
        verification.collect(rows, places.build_dir() / "verification.json")
    if status:
        raise RunError(f"tests failed after {time.monotonic() - start:.0f} s; see above")
    return 0
