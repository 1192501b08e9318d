#!/usr/bin/env python3
"""Regenerates stability_map.csv beside this file and the tables of docs/stability.md (minutes):

    /usr/bin/python3 docs/results/stability_map.py [--jobs N] [--only WORD]

Every scene of tests/cases/stability is checked as `slidewave check` does and run as `run --force` does, a
core each. Exit status 1 where a scene that the check accepts fails, or more than a fifth of those that
it refuses run well. --only runs a part again and leaves the other rows as they are.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
sys.path.insert(0, str(ROOT))
os.environ.setdefault("SLIDEWAVE_BUILD", str(ROOT / "build"))

from tests.cases.stability import tables  # noqa: E402
from tests.cases.stability.scenes import all_scenes  # noqa: E402
from tests.cases.stability.trial import Outcome, attempt  # noqa: E402


def one(title: str) -> Outcome:
    """The outcome of one scene, in a process of its own."""
    scene = next(s for s in all_scenes() if s.title == title)
    with tempfile.TemporaryDirectory(prefix="slidewave-map-") as place:
        return attempt(scene, Path(place).resolve() / "scene")


def main() -> int:
    """Runs the scenes, writes both files, says where the demands do not hold."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", metavar="N", type=int, default=1, help="scenes at a time")
    parser.add_argument("--only", metavar="WORD", default="", help="scenes whose title holds this")
    options = parser.parse_args()
    scenes = all_scenes()
    seen = tables.read_csv(HERE / "stability_map.csv")
    with multiprocessing.Pool(options.jobs) as pool:
        for outcome in pool.imap(one, [s.title for s in scenes if options.only in s.title]):
            seen[outcome.title] = outcome
            print(f"{outcome.title:<58} {outcome.verdict:<8} {'stable' if outcome.stable else 'fails':<7} "
                  f"{outcome.error:9.3g} {outcome.wall_s:6.1f} s  {outcome.limiting} {outcome.limit}  {outcome.why}", flush=True)
    outcomes = [seen[s.title] for s in scenes if s.title in seen]
    tables.write_csv(HERE / "stability_map.csv", outcomes)
    tables.put_into(ROOT / "docs/stability.md", tables.markdown(outcomes))
    for name, counts in tables.confusion(outcomes).items():
        print(f"{name}: {counts[0]} run well, {counts[1]} miss 5 %, {counts[2]} fail")
    wrong = tables.faults(outcomes)
    print("\n".join(wrong) or "both demands hold")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
