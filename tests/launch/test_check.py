"""The pre-flight check through the command line: exit status, key named, and a value that works."""

import json
import unittest

from tests.launch.scratch import ScratchCase


class Check(ScratchCase):
    def findings(self, *more: str) -> tuple[int, list[dict]]:
        status, out, err = self.slidewave("check", self.case, "--json", *more)
        self.assertIn(status, (0, 1), err)
        return status, json.loads(out)

    def test_sound_scene(self) -> None:
        for variant in ("two_way", "one_way", "re_1", "re_100", "stiff"):
            status, rows = self.findings("--variant", variant)
            self.assertEqual((status, [r for r in rows if r["verdict"] == "bad"]), (0, []), variant)
            self.assertEqual({r["value"] for r in rows if r["quantity"] == "particles"}, {1})

    def test_bad_step_names_the_key_and_a_value_that_works(self) -> None:
        stiff = ("--set", "parameters.contact_stiffness=1e4")
        status, rows = self.findings(*stiff)
        self.assertEqual(status, 1)
        bad = [r for r in rows if r["verdict"] == "bad"]
        self.assertEqual({r["key"] for r in bad}, {"parameters.dem_dt"})
        works = min(r["works"] for r in bad)
        self.assertEqual(self.findings(*stiff, "--set", f"parameters.dem_dt={works}")[0], 0)

    def test_run_refuses_unless_forced(self) -> None:
        stiff = ("--set", "parameters.contact_stiffness=1e4")
        status, out, err = self.dry_run(*stiff)
        self.assertEqual(status, 1)
        self.assertIn("parameters.dem_dt", out)
        self.assertIn("--force", err)
        self.assertEqual(self.dry_run(*stiff, "--force")[0], 0)


if __name__ == "__main__":
    unittest.main()
