"""The study command without engines: resumption, failed points, references, refusals, ablation."""

import csv
import unittest
from pathlib import Path

from launch import study_results
from launch.study_points import Point
from tests.launch.fake_study import FakeRunner, StudyCase

WINDOW = "coupling.window=4e-3,2e-3,1e-3"
INTERVAL = ("--set", "case.end_time=0.12", "--set", "output.interval=0.12")


def linear(point: Point) -> float:
    """A first-order quantity: the target's reference, and 1 % for each millisecond of window."""
    return -0.013275 * (1 + 0.01 * float(point.text("coupling.window") or 5e-4) / 1e-3)


def cost(point: Point) -> float:
    return 1e-2 / float(point.text("coupling.window") or 5e-4)


class Study(StudyCase):
    def rows(self) -> list[dict[str, str]]:
        with (self.place / "study/study.csv").open(newline="") as stream:
            return list(csv.DictReader(stream))

    def test_errors_order_and_sentence(self) -> None:
        status, text = self.study(FakeRunner(linear, cost), "--vary", WINDOW, *INTERVAL)
        self.assertEqual(status, 0, text)
        self.assertIn("3 points, 3 runs, 210 windows in all", text)
        self.assertIn("[1/3] window=4e-3: done, about", text)
        self.assertIn("terminal velocity, coupling.window: order 1.00", text)
        self.assertIn("for an error of 2 % use window=2e-3, it takes 5 s, 10 core seconds", text)
        rows = self.rows()
        self.assertEqual([r["coupling.window"] for r in rows], ["4e-3", "2e-3", "1e-3"])
        for row, error in zip(rows, (0.04, 0.02, 0.01)):
            self.assertAlmostEqual(float(row["terminal velocity error"]), error)
            self.assertEqual(row["terminal velocity reference"], "-0.013275")
            self.assertEqual((row["status"], row["on_front"], row["momentum_defect"]),
                             ("completed", "1", "1e-16"))
        picture = (self.place / "study/study.svg").read_text()
        self.assertIn("window=1e-3", picture)

    def test_complete_points_are_not_run_again(self) -> None:
        fails = FakeRunner(linear, cost, lambda p: p.text("coupling.window") == "2e-3")
        self.assertEqual(self.study(fails, "--vary", WINDOW, *INTERVAL)[0], 1)
        again = FakeRunner(linear, cost)
        status, text = self.study(again, "--vary", WINDOW + ",5e-4", *INTERVAL)
        self.assertEqual((status, again.seen), (0, ["window=2e-3", "window=5e-4"]))
        self.assertIn("2 of 4 runs are complete already", text)
        self.assertEqual([r["status"] for r in self.rows()], ["completed"] * 4)
        changed = FakeRunner(linear, cost)
        self.study(changed, "--vary", WINDOW, *INTERVAL, "--set", "parameters.fluid_viscosity=0.3")
        self.assertEqual(len(changed.seen), 3, "another scene: its points are others")
        self.change("dem/in.setup", "variable diameter index 2e-3", "variable diameter index 1e-3")
        edited = FakeRunner(linear, cost)
        self.study(edited, "--vary", WINDOW, *INTERVAL)
        self.assertEqual(len(edited.seen), 3, "an edited input file: its points are others")

    def test_failed_point_is_a_row(self) -> None:
        def broken(point: Point) -> float:
            if point.text("coupling.window") == "1e-3":
                raise ValueError("the fake broke")
            return linear(point)

        runner = FakeRunner(broken, cost, lambda p: p.text("coupling.window") == "4e-3")
        status, text = self.study(runner, "--vary", WINDOW, *INTERVAL)
        rows = self.rows()
        self.assertEqual((status, [r["status"] for r in rows]), (1, ["failed", "completed", "failed"]))
        self.assertEqual(rows[0]["reason"], "dem rank 0: made to fail")
        self.assertIn("the fake broke", rows[2]["reason"])
        self.assertIn("2 of 3 points failed", text)
        self.assertIn("use window=2e-3", text)

    def test_point_that_does_not_fit_is_a_row(self) -> None:
        runner = FakeRunner(linear, cost)
        status, _ = self.study(runner, "--vary", "coupling.window=7e-3,2e-3", *INTERVAL)
        self.assertEqual((status, runner.seen), (1, ["window=2e-3"]))
        self.assertIn("must be a whole number of windows", self.rows()[0]["reason"])

    def test_best_run_is_the_reference(self) -> None:
        _, text = self.study(FakeRunner(linear, cost), "--vary", WINDOW + ",5e-4", *INTERVAL,
                             "--reference", "best", "--quantity", "final:sphere_vz_m_s")
        rows = self.rows()
        self.assertEqual([r["is_reference"] for r in rows], ["0", "0", "0", "1"])
        self.assertEqual([r["on_front"] for r in rows], ["1", "1", "1", "0"])
        self.assertIn("coupling.window: order 1.00", text)
        self.assertIn("which by the order is 0.5 % off itself", text)

    def test_reference_files(self) -> None:
        table, curve = self.place / "table.csv", self.place / "curve.csv"
        table.write_text("quantity,value\nterminal velocity,-0.0135405\n")
        self.study(FakeRunner(linear, cost), "--vary", WINDOW, *INTERVAL, "--reference", str(table))
        self.assertAlmostEqual(float(self.rows()[1]["error"]), 0)
        curve.write_text("time_s,sphere_vz_m_s\n0,0\n0.1,-0.013275\n")
        self.study(FakeRunner(linear, cost), "--vary", WINDOW, *INTERVAL, "--reference", str(curve),
                   "--quantity", "curve:sphere_vz_m_s")
        self.assertAlmostEqual(float(self.rows()[0]["error"]), 0.04)

    def test_history_of_one_of_the_runs_is_known_as_the_reference(self) -> None:
        words = ("--vary", WINDOW, *INTERVAL, "--quantity", "curve:sphere_vz_m_s")
        self.study(FakeRunner(linear, cost), *words)
        base = next(h for h in sorted((self.place / "study/points").glob("*/history.csv")) if "2e-3" in str(h))
        kept = self.place / "kept.csv"
        kept.write_bytes(base.read_bytes())
        self.study(FakeRunner(linear, cost), *words, "--reference", str(kept))
        self.assertEqual([(r["is_reference"], r["on_front"]) for r in self.rows()],
                         [("0", "1"), ("1", "0"), ("0", "1")])

    def test_groups_repeats_list_and_jobs(self) -> None:
        file = self.place / "list.csv"
        file.write_text("coupling.reaction,coupling.window\n# finest last\none_way,2e-3\none_way,1e-3\n"
                        "two_way,2e-3\ntwo_way,1e-3\n")
        runner = FakeRunner(linear, cost)
        status, text = self.study(runner, "--list", str(file), *INTERVAL, "--group", "coupling.reaction",
                                  "--reference", "best", "--repeat", "2", "--jobs", "3")
        self.assertEqual((status, len(runner.seen)), (0, 8))
        self.assertEqual([r["is_reference"] for r in self.rows()], ["0", "1"] * 2)
        self.assertEqual({r["repeats"] for r in self.rows()}, {"2"})
        for name in ("one_way", "two_way"):  # no order from two points: the floor is not known
            self.assertIn(f"for {name}: for an error of 2 % use reaction={name}, window=2e-3", text)

    def test_processor_time_of_both_sides_without_waiting(self) -> None:
        summary = {"ranks": {"fluid": 2, "dem": 1}, "processor_timings": {
            "fluid": {"solve": 3.0, "force": 1.0, "wait": 50.0}, "dem": {"solve": 5.0, "wait": 9.0}}}
        self.assertEqual(study_results.worked_s(summary), 13.0)

    def test_ablation(self) -> None:
        change = {"models.drag": 2.0, "models.pressure_gradient": 1.5, "coupling.reaction": 0.95}

        def value(point: Point) -> float:
            return -0.0133 * (change[point.settings[0][0]] if point.settings else 1.0)

        status, text = self.study(FakeRunner(value, lambda p: 1.0 if p.settings else 2.0), "--ablate")
        self.assertEqual(status, 0, text)
        self.assertIn("without drag: terminal velocity -100 %; run time -50 %", text)
        self.assertIn("without reaction on the fluid: terminal velocity +5 %", text)
        self.assertEqual([r["point"] for r in self.rows()][0], "as it is")
        runner = FakeRunner(value)
        self.study(runner, "--ablate", "--variant", "one_way")
        self.assertNotIn("without reaction on the fluid", runner.seen)

    def test_refusals_name_key_value_and_remedy(self) -> None:
        good = ("--vary", WINDOW, *INTERVAL)
        for words, parts in (
            ((), ("--vary", "missing")),
            (("--vary", "coupling.windw=1,2"), ("coupling.windw", "did you mean 'coupling.window'?")),
            (("--vary", "coupling.window=1e-3,-1"), ("coupling.window = -1", "above 0")),
            (("--vary", "coupling.window"), ("write key=v1,v2",)),
            (("--vary", "coupling.window=7e-3,9e-3"), ("no point can run", "whole number of windows")),
            ((*good, "--quantity", "terminal velocit"), ("did you mean 'terminal velocity'?",)),
            ((*good, "--quantity", "final:x", "--reference", "analytic"), ("is no [[target]]",)),
            ((*good, "--reference", "nowhere.csv"), ("nowhere.csv", "cannot be read")),
            ((*good, "--group", "models.drag"), ("is not varied",)),
            ((*good, "--ablate"), ("do not go together",)),
            (("--list", str(self.place / "none.csv")), ("none.csv", "cannot be read")),
        ):
            with self.subTest(words=words):
                message = self.refused(*words)
                for part in parts:
                    self.assertIn(part, message)
        self.assertFalse((self.place / "study").exists())

    def test_directory_with_other_files_is_refused(self) -> None:
        (self.place / "study").mkdir()
        Path(self.place / "study/thesis.txt").write_text("mine")
        self.assertIn("holds files but no study", self.refused("--vary", WINDOW, *INTERVAL))

    def test_exit_status_of_bad_input(self) -> None:
        status, _, error = self.slidewave("study", self.case, "--vary", "coupling.windw=1")
        self.assertEqual(status, 2)
        self.assertIn("coupling.windw", error)


if __name__ == "__main__":
    unittest.main()
