"""The resolved case survives writing and reading; hints find the key that was meant."""

import tomllib
import unittest

from launch import schema, toml_out
from launch.errors import did_you_mean, edit_distance


class RoundTrip(unittest.TestCase):
    def test_toml_reads_back_the_same(self) -> None:
        data = {"a": 0.1, "n": -3, "t": 'quote " back \\ line\nend', "flag": True, "unicode": "Réservoir",
                "table": {"deep": {"list": [1.5, 2.0], "points": [[0.0, 1.0], [2.0, 3.0]]}, "x-y": "z",
                          "a key": 1}, "empty": {}, "none": [],
                "target": [{"name": "p", "reference": 1e-300}, {"name": "q", "reference": 1e22}]}
        self.assertEqual(tomllib.loads(toml_out.dumps(data)), data)

    def test_numbers_keep_every_digit(self) -> None:
        for value in (0.1 + 0.2, 1 / 3, 5e-324, 1.7976931348623157e308, 2**53 + 1):
            self.assertEqual(tomllib.loads(f"v = {toml_out.value_text(value)}")["v"], value)


class Hints(unittest.TestCase):
    def test_edit_distance(self) -> None:
        for a, b, distance in (("", "abc", 3), ("kitten", "sitting", 3), ("same", "same", 0)):
            self.assertEqual(edit_distance(a, b), distance)
            self.assertEqual(edit_distance(b, a), distance)

    def test_no_hint_where_nothing_is_close(self) -> None:
        self.assertEqual(did_you_mean("zzzzzz", ["window", "scheme"]), "")

    def test_patterns(self) -> None:
        self.assertEqual(schema.find_key("observe.wave.type").kind, "text")
        self.assertEqual(schema.find_key("observe.wave.level").kind, "number")
        self.assertEqual(schema.find_key("geometry.ground.points").kind, "any")
        self.assertEqual(schema.find_key("parameters.anything").kind, "scalar")
        self.assertEqual(schema.find_key("parameters.dem_dt").unit, "s")
        self.assertIsNone(schema.find_key("parameters.a.b"))
        self.assertIsNone(schema.find_key("coupling.widnow"))


if __name__ == "__main__":
    unittest.main()
