"""Grid, Pareto front, order of convergence and the sentence on made-up data with known answers."""

import itertools
import random
import unittest

import numpy as np

from launch import study_analysis
from launch import study_quantities as quantities
from launch.errors import InputError
from launch.study_points import Point, expand, file_name, parse_vary, split_values
from launch.study_results import Row, best


def row(error: float | None, wall_s: float, reference: bool = False, **settings: str) -> Row:
    """A complete row; keyword a=1 is the setting k.a=1."""
    point = Point(tuple((f"k.{name}", value) for name, value in settings.items()))
    done = Row(point, "completed", wall_s=wall_s, core_s=2 * wall_s, worst=error, is_reference=reference)
    if error is not None:
        done.errors["q"] = error
    return done


class Grid(unittest.TestCase):
    def test_all_combinations_last_key_fastest(self) -> None:
        points = expand([("a.x", ["1", "2"]), ("b.y", ["u", "v", "w"])], [])
        self.assertEqual([(p.text("a.x"), p.text("b.y")) for p in points],
                         list(itertools.product("12", "uvw")))
        self.assertEqual(points[-1].label, "x=2, y=w")
        self.assertEqual(points[-1].words, ["a.x=2", "b.y=w"])

    def test_list_times_grid(self) -> None:
        points = expand([("c.z", ["7", "8"])], [(("a.x", "1"),), (("b.y", "2"),)])
        self.assertEqual([p.words for p in points], [["a.x=1", "c.z=7"], ["a.x=1", "c.z=8"],
                                                     ["b.y=2", "c.z=7"], ["b.y=2", "c.z=8"]])

    def test_values_with_commas(self) -> None:
        self.assertEqual(split_values("[0,0,-1], [0,0,-2]"), ["[0,0,-1]", "[0,0,-2]"])
        self.assertEqual(split_values("'a,b',c"), ["'a,b'", "c"])
        self.assertEqual(parse_vary("a.b = 1, 2e-3"), ("a.b", ["1", "2e-3"]))

    def test_refusals(self) -> None:
        for text in ("a.b", "a.b=", "=1,2", "a.b=1,,2", "a.b=1,1"):
            with self.subTest(text=text), self.assertRaises(InputError):
                parse_vary(text)
        with self.assertRaises(InputError):
            expand([("a", ["1"]), ("a", ["2"])], [])

    def test_file_names_are_plain(self) -> None:
        point = Point((("physics.gravity", "[0, 0, -9.81]"), ("a.text", "x/y; z")))
        self.assertRegex(file_name(point, "0123abcd", 2), r"^[A-Za-z0-9.+_-]+-0123abcd-r2$")


class Front(unittest.TestCase):
    def test_processor_time_in_place_of_wall_time(self) -> None:
        """By wall time the second is the cheapest (nothing else ran then), by work done the first."""
        rows = [row(0.1, 9.0), row(0.2, 5.0)]
        rows[0].processor_s, rows[1].processor_s = 3.0, 4.0
        study_analysis.mark_front(rows)
        self.assertTrue(rows[0].on_front and rows[1].on_front)
        for done in rows:
            done.by, done.on_front = "processor", False
        study_analysis.mark_front(rows)
        self.assertTrue(rows[0].on_front and not rows[1].on_front)
        self.assertIn("3 s of processor time", study_analysis.sentence(rows, 0.5))

    def test_against_brute_force(self) -> None:
        draw = random.Random(7)
        for _ in range(50):
            points = [(draw.randint(1, 9), draw.randint(1, 9)) for _ in range(12)]
            found = study_analysis.front(*map(list, zip(*points)))
            beaten = [any(c <= a and e <= b and (c, e) != (a, b) for c, e in points) for a, b in points]
            self.assertEqual({points[i] for i in found},
                             {p for p, worse in zip(points, beaten) if not worse})
            self.assertEqual([points[i][0] for i in found], sorted(points[i][0] for i in found))

    def test_reference_takes_no_part(self) -> None:
        rows = [row(0.1, 1, x="2"), row(0.2, 2, x="3"), row(0.0, 9, True, x="1")]
        study_analysis.mark_front(rows)
        self.assertEqual([r.on_front for r in rows], [True, False, False])


class Order(unittest.TestCase):
    def test_true_errors(self) -> None:
        sizes = [0.4, 0.2, 0.1, 0.05]
        for order in (-2.0, 0.5, 1.0, 2.0, 3.7):
            errors = [0.3 * h**order for h in sizes]
            found, residual = study_analysis.fit_order(sizes, errors)
            self.assertAlmostEqual(found, order, delta=1e-3)
            self.assertLess(residual, 2e-3)

    def test_errors_against_the_finest_run_are_not_biased(self) -> None:
        sizes = [0.4, 0.2, 0.1]
        for order in (1.0, 2.0):
            errors = [3.0 * (h**order - 0.05**order) for h in sizes]
            self.assertAlmostEqual(study_analysis.fit_order(sizes, errors, 0.05)[0], order, delta=1e-3)
            naive = np.polyfit(np.log(sizes), np.log(errors), 1)[0]
            self.assertGreater(naive, order + 0.03)

    def test_one_order_a_key(self) -> None:
        """e = 2 x + 3 y^2 measured against x = 0.1, y = 0.1; each key along the line of the other."""
        exact = lambda x, y: 2 * x + 3 * y**2  # noqa: E731
        rows = [row(exact(x, y) - exact(0.1, 0.1), 1, (x, y) == (0.1, 0.1), x=str(x), y=str(y), m="word")
                for x in (0.8, 0.4, 0.2, 0.1) for y in (0.8, 0.4, 0.2, 0.1)]
        found = {o.key: o for o in study_analysis.orders(rows, "q")}
        self.assertEqual(set(found), {"k.x", "k.y"})
        self.assertAlmostEqual(found["k.x"].order, 1, delta=0.01)
        self.assertAlmostEqual(found["k.y"].order, 2, delta=0.01)
        self.assertEqual(found["k.x"].points, 3)

    def test_error_of_the_finest_run_itself(self) -> None:
        """e = 0.2 x; against x = 0.05 that has 0.01 itself. A twin of the reference is not judged."""
        rows = [row(0.2 * (x - 0.05), 9 - x, x=str(x), y="1") for x in (0.4, 0.2, 0.1)]
        rows += [row(1e-9, 5, x="0.05", y="2"), row(0.0, 9, True, x="0.05", y="1")]
        self.assertAlmostEqual(study_analysis.set_floor(rows, ["q"]), 0.01, delta=1e-4)
        self.assertEqual([r.counts for r in rows], [True, True, True, False, False])
        self.assertIn("no run reaches", study_analysis.sentence(rows, 0.0195))
        self.assertIn("use x=0.1", study_analysis.sentence(rows, 0.021))

    def test_key_without_effect_is_told(self) -> None:
        rows = [row(0.1 * noise, 1, x=x) for x, noise in (("4", 1.001), ("2", 1.0), ("1", 0.999))]
        self.assertEqual(str(study_analysis.orders(rows, "q")[0]), "k.x: no effect on the error (3 points)")

    def test_two_points_give_no_order(self) -> None:
        self.assertEqual(study_analysis.orders([row(0.2, 1, x="2"), row(0.1, 2, x="1")], "q"), [])


class Sentence(unittest.TestCase):
    ROWS = [row(0.10, 1, x="8"), row(0.015, 3, x="4"), row(0.018, 2.5, x="3"), row(0.001, 40, x="1"),
            row(0.0, 99, True, x="0.5")]

    def test_cheapest_that_is_good_enough(self) -> None:
        self.assertEqual(study_analysis.sentence(self.ROWS, 0.02), "for an error of 2 % use x=3, it takes "
                         "2.5 s, 5 core seconds (error 1.8 %)")
        self.assertIn("use x=1, it takes 40 s", study_analysis.sentence(self.ROWS, 0.002))

    def test_none_is_good_enough(self) -> None:
        text = study_analysis.sentence(self.ROWS, 1e-4, "one_way")
        self.assertIn("for one_way: no run reaches an error of 0.01 %; the nearest is x=1 with 0.1 %", text)
        self.assertIn("no run can be judged", study_analysis.sentence(self.ROWS[-1:], 0.02))

    def test_finest_run(self) -> None:
        failed = Row(Point((("k.x", "0.1"),)), "failed")
        self.assertEqual(best(self.ROWS[:3], True), self.ROWS[2])
        self.assertEqual(best([*self.ROWS[:3], failed], True), self.ROWS[1])
        self.assertEqual(best(self.ROWS[:3], False), self.ROWS[1])
        self.assertIsNone(best([failed], True))


class Quantities(unittest.TestCase):
    def test_curve_error_is_the_largest_difference(self) -> None:
        times = np.linspace(0, 1, 11)
        run = {"time_s": times, "v": times**2}
        reference = quantities.Reference("made up", history={"time_s": np.linspace(0, 0.5, 6),
                                                             "v": np.linspace(0, 0.5, 6)})
        curve = quantities.Quantity("curve:v", "v", "curve")
        self.assertAlmostEqual(reference.error(curve, run), 0.25 / 0.5)  # at t = 0.5, beyond is not covered

    def test_error_against_nothing_is_absolute(self) -> None:
        final = quantities.Quantity("final:v", "v", "final")
        run = {"time_s": np.array([0.0, 1.0]), "v": np.array([0.0, 0.3])}
        self.assertAlmostEqual(quantities.Reference("r", {"final:v": 0.0}).error(final, run), 0.3)
        self.assertAlmostEqual(quantities.Reference("r", {"final:v": -0.2}).error(final, run), 2.5)


if __name__ == "__main__":
    unittest.main()
