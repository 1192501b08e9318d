"""The pre-flight check through the command line: exit status, key named, and a value that works."""

import json
import unittest
from unittest import mock

from launch.case import read_toml
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

    def scheme(self, cores: int, *more: str) -> str:
        """What coupling.scheme = "auto" becomes for a machine with so many cores."""
        with mock.patch("launch.ranks.cores", return_value=cores):
            status, _, err = self.dry_run("--set", "coupling.scheme=auto", "--ranks-fluid", "1", "--ranks-dem", "1",
                                          "--overwrite", *more)
        self.assertEqual(status, 0, err)
        return read_toml(self.place / "run/case.toml")["coupling"]["scheme"]

    def test_scheme_is_chosen(self) -> None:
        self.assertEqual(self.scheme(2), "concurrent")
        self.assertEqual(self.scheme(1), "serial")
        self.assertEqual(self.scheme(2, "--set", "coupling.window=1e-3"), "serial")  # K W/m = 0.46
        self.assertEqual(self.scheme(2, "--variant", "uniform"), "serial")  # nothing to gain

    def test_concurrent_is_refused_by_number(self) -> None:
        beyond = ("--set", "coupling.scheme=concurrent", "--set", "coupling.window=1e-3")
        status, rows = self.findings(*beyond)
        bad = [r for r in rows if r["verdict"] == "bad"]
        self.assertEqual((status, [r["key"] for r in bad]), (1, ["coupling.window"]))
        self.assertLess(bad[0]["limit"], bad[0]["value"])
        self.assertGreater(bad[0]["works"], 5e-4)
        self.assertEqual(self.findings(*beyond[:2])[0], 0)  # 5e-4 s, the case's own


if __name__ == "__main__":
    unittest.main()
