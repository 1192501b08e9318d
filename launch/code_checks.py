"""Checks of our own C++ that need no run: format (clang-format), lint (clang-tidy), and the coupling
library's tests under the address and undefined-behaviour sanitizers, in a build of their own."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

from launch import places
from launch.errors import RunError
from launch.progress import say

SOURCES = ("*.cpp", "*.hpp", "*.h", "*.C", "*.H")
FLAGS = "-Og -g1"  # -O0 takes two to ten times as long; assert() stays, a report names file and line
TESTED = ("coupler/engines/all", "tests/coupler/all", "tests/pair/all")  # what those tests run
LINTED = ("coupler/src", "coupler/tools", "coupler/engines", "dem_side", "dem_lammps")


def own_sources() -> list[str]:
    """Our C++ files that exist, below the source tree; OpenFOAM dictionaries of cases left out."""
    listed = subprocess.run(["git", "-C", str(places.ROOT), "ls-files", "-z", "--", *SOURCES],
                            capture_output=True, text=True, check=False)
    if listed.returncode == 0:
        names = [n for n in listed.stdout.split("\0") if n]
    else:  # an unpacked archive
        names = [str(p.relative_to(places.ROOT)) for top in ("coupler", "foam_side", "dem_side", "dem_lammps", "dem_esys", "tests")
                 for pattern in SOURCES for p in (places.ROOT / top).rglob(pattern)]
    return [n for n in names if not n.startswith("cases/") and (places.ROOT / n).is_file()]


def format_is_right() -> None:
    """RunError where clang-format would change a file."""
    names = own_sources()
    if names:
        done = subprocess.run(["clang-format", "--dry-run", "-Werror", *names], cwd=places.ROOT,
                              check=False)
        if done.returncode:
            raise RunError("format: run clang-format -i on the files above")
    say(f"format of {len(names)} files is right")


def lint(full: bool = False) -> None:
    """RunError where clang-tidy finds something in the coupler or the LIGGGHTS side; its static analyzer, half
    of the time, takes part where `full`. OpenFOAM's headers, which make up most of foam_side's compilation,
    are not clean enough for it."""
    folders = "|".join(re.escape(str(places.ROOT / folder)) for folder in LINTED)
    checks = [] if full else ["-checks=-clang-analyzer-*"]
    done = subprocess.run(["run-clang-tidy", "-p", str(places.build_dir()), "-quiet", *checks,
                           f"({folders})/.*"], cwd=places.ROOT, capture_output=True, text=True,
                          check=False)
    if done.returncode:
        found = [line for line in done.stdout.splitlines() if "clang-tidy-" not in line]
        raise RunError("lint: clang-tidy found\n" + "\n".join(found))
    say("lint found nothing")


def under_sanitizers() -> None:
    """RunError where a test of the coupler fails under ASan and UBSan."""
    build = places.build_dir() / "sanitize"
    _quietly(["cmake", "-S", str(places.ROOT), "-B", str(build), "-G", "Ninja",
              "-DCMAKE_BUILD_TYPE=Debug", f"-DCMAKE_CXX_FLAGS_DEBUG={FLAGS}", "-DSLIDEWAVE_SANITIZE=ON",
              "-DSLIDEWAVE_WITH_OPENFOAM=OFF", "-DSLIDEWAVE_WITH_LIGGGHTS=OFF",
              "-DSLIDEWAVE_WITH_LAMMPS=OFF", "-DSLIDEWAVE_WITH_ESYS=OFF"], "sanitizers: cmake")
    _quietly(["ninja", "-C", str(build), *TESTED], "sanitizers: build")
    _quietly(["ctest", "--test-dir", str(build), "-L", "coupler", "-LE", "timed", "-j4",
              "--output-on-failure"], "sanitizers: tests")
    say("the coupler's tests pass under ASan and UBSan")


def _quietly(words: list[str], what: str) -> None:
    environment = {k: v for k, v in os.environ.items() if k != "SLIDEWAVE_BUILD"}
    done = subprocess.run(words, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    if done.returncode:
        raise RunError(f"{what} failed:\n{done.stdout}")
