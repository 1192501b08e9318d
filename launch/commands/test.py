"""Builds (the bootstrap did), checks the format of our own sources, runs the tests with ctest.

--full runs the slow verification too and writes build/verification.json, a row a comparison.
ctest's own summary closes the output.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import time

from launch import places, verification
from launch.errors import RunError
from launch.progress import say

NAME = "test"
HELP = "build and pass the tests"
SOURCES = ("*.cpp", "*.hpp", "*.h", "*.C", "*.H")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Adds the options of `test`."""
    parser.add_argument("--full", action="store_true", help="slow verification too (label full)")


def own_sources() -> list[str]:
    """Our C++ files that exist, below the source tree; OpenFOAM dictionaries of cases left out."""
    listed = subprocess.run(["git", "-C", str(places.ROOT), "ls-files", "-z", "--", *SOURCES],
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        names = [n for n in listed.stdout.split("\0") if n]
    else:  # an unpacked archive
        names = [str(p.relative_to(places.ROOT)) for top in ("coupler", "foam_side", "dem_side", "tests")
                 for pattern in SOURCES for p in (places.ROOT / top).rglob(pattern)]
    return [n for n in names if not n.startswith("cases/") and (places.ROOT / n).is_file()]


def check_format() -> None:
    """RunError where clang-format would change a file."""
    names = own_sources()
    if names:
        done = subprocess.run(["clang-format", "--dry-run", "-Werror", *names], cwd=places.ROOT,
                              check=False)
        if done.returncode:
            raise RunError("format: run clang-format -i on the files above")
    say(f"format of {len(names)} files is right")


def main(options: argparse.Namespace) -> int:
    """Runs the command; exit status 1 where a test fails."""
    start = time.monotonic()
    check_format()
    say(f"stage format: {time.monotonic() - start:.1f} s")
    start = time.monotonic()
    words = ["ctest", "--test-dir", str(places.build_dir()), "-j2", "--output-on-failure"]
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
