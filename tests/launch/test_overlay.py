"""Variants and --set: tables merge, targets merge by name, types stay."""

import unittest

from launch import case as cases
from launch.errors import InputError
from launch.overlay import apply_setting, overlay, parse_setting
from tests.launch.scratch import ScratchCase


class Overlay(unittest.TestCase):
    def test_tables_merge_and_values_replace(self) -> None:
        base = {"a": {"x": 1, "y": [1, 2]}, "b": 2}
        self.assertEqual(overlay(base, {"a": {"y": [3]}, "c": 4}),
                         {"a": {"x": 1, "y": [3]}, "b": 2, "c": 4})
        self.assertEqual(base, {"a": {"x": 1, "y": [1, 2]}, "b": 2}, "the base was changed")

    def test_targets_merge_by_name(self) -> None:
        base = {"target": [{"name": "p", "reference": 1, "source": "s"}, {"name": "q", "reference": 2}]}
        merged = overlay(base, {"target": [{"name": "q", "reference": 5}, {"name": "r"}]})
        self.assertEqual(merged["target"], [{"name": "p", "reference": 1, "source": "s"},
                                            {"name": "q", "reference": 5}, {"name": "r"}])

    def test_setting_values(self) -> None:
        self.assertEqual(parse_setting("a.b=1e-3"), ("a.b", 1e-3))
        self.assertEqual(parse_setting("a = [0, 0, -1]"), ("a", [0, 0, -1]))
        self.assertEqual(parse_setting("a.b=one_way"), ("a.b", "one_way"))
        self.assertEqual(parse_setting("a=x=y"), ("a", "x=y"))
        for bad in ("a", "=1", "a="):
            with self.assertRaises(InputError):
                parse_setting(bad)

    def test_setting_needs_a_known_key_and_its_type(self) -> None:
        data = {"parameters": {"rho": 1000.0}}
        apply_setting(data, "parameters.rho=900")
        apply_setting(data, "parameters.dem_dt=1e-4")
        self.assertEqual(data["parameters"], {"rho": 900, "dem_dt": 1e-4})
        for text, remedy in (("rho=3", "parameters.rho"), ("parameters.rhoo=3", "did you mean 'rho'"),
                             ("parameters.rho=heavy", "give a number"), ("case.end=3", "case.end_time"),
                             ("coupling.window=-1", "above 0"), ("target.name=x", "unknown key")):
            with self.assertRaises(InputError) as caught:
                apply_setting(data, text)
            self.assertIn(remedy, str(caught.exception))


class Loading(ScratchCase):
    def test_variant_then_settings(self) -> None:
        base = cases.load(str(self.case))
        self.assertEqual((base.variant, base.get("coupling.reaction")), ("two_way", "two_way"))
        stiff = cases.load(str(self.case), "stiff", ["coupling.window=4.4e-3"])
        self.assertEqual(stiff.get("coupling.window"), 4.4e-3)
        self.assertEqual(stiff.get("parameters.dem_dt"), 2.2e-3)
        self.assertEqual(stiff.get("parameters.diameter"), 2e-3)
        self.assertEqual(len(stiff.get("target")), 1)
        self.assertEqual(stiff.get("target")[0]["required"], True)

    def test_names_stand_for_parameters(self) -> None:
        self.change("case.toml", "[observe.sphere]",
                    '[observe.level]\ntype = "gauge"\nx = "$start_height"\n\n[observe.sphere]')
        case = cases.load(str(self.case), "one_way", ["parameters.start_height=0.03"])
        self.assertEqual(case.get("observe.level.x"), 0.03)
        self.assertIn("start_height", case.used)


if __name__ == "__main__":
    unittest.main()
