"""The stability map's demands on a few scenes; all of them in `test --full`. No accepted scene fails; of the
refused at least four fifths fail or miss 5 %: a row of verification.json in the full test, which the
map misses so far (docs/stability.md). And the judge sees what it must see."""

import os
import tempfile
import unittest
from pathlib import Path

from launch import verification
from tests.cases.stability import tables
from tests.cases.stability.scenes import all_scenes
from tests.cases.stability.trial import Outcome, attempt

FULL = "SLIDEWAVE_VERIFICATION" in os.environ


def outcomes(scenes: list) -> list[Outcome]:
    found = []
    for scene in scenes:
        with tempfile.TemporaryDirectory() as place:
            found.append(attempt(scene, Path(place).resolve() / "scene"))
    return found


class Map(unittest.TestCase):
    def hold(self, scenes: list) -> None:
        seen = outcomes(scenes)
        self.assertEqual(tables.faults(seen), [], [vars(o) for o in seen])

    def test_quick(self) -> None:
        scenes = [s for s in all_scenes() if s.quick]
        self.assertGreater(len(scenes), 5)
        self.hold(scenes)

    @unittest.skipUnless(FULL, "full verification only")
    def test_full(self) -> None:
        seen = outcomes(all_scenes())
        self.assertEqual([o.title for o in seen if o.accepted and not o.stable], [])
        well, missed, failed = tables.confusion(seen)["refused"]
        verification.record("stability map", "share of refused scenes that run well", well / (well + missed + failed), 0,
                            1 - tables.CAUGHT, sum(o.wall_s for o in seen))


class Judge(unittest.TestCase):
    """The demands and tables on outcomes made up here."""

    def test_names_are_unique(self) -> None:
        titles = [s.title for s in all_scenes()]
        self.assertEqual(len(set(titles)), len(titles))

    def test_faults(self) -> None:
        good = Outcome("a: accepted", "ok", stable=True, error=0.01)
        blown = Outcome("a: blown", "warn", stable=False, why="lost")
        caught = [Outcome(f"a: {n}", "bad", stable=n % 2 == 0, error=0.2) for n in range(4)]
        well = Outcome("a: well", "bad", stable=True, error=0.01)
        self.assertEqual(tables.faults([good, *caught, well]), [])
        self.assertEqual(len(tables.faults([good, *caught, well, well])), 1)
        self.assertIn("a: blown", tables.faults([blown])[0])
        self.assertEqual(tables.confusion([good, blown, *caught, well])["refused"], (1, 2, 2))
        self.assertIn("| accepted | 1 | 0 | 1 |", tables.markdown([good, blown]))


if __name__ == "__main__":
    unittest.main()
