"""The report on made-up run directories: two fluids in two parts, one fluid, dry, nothing at all."""

import json
import re
import tempfile
import unittest
from pathlib import Path

import numpy as np

from launch import results, section_data, section_plot, toml_out
from launch.commands import report
from tests.launch import handmade

TARGETS = [
    {"name": "height", "column": "wave_height_m", "reference": 10.0, "tolerance": 0.2, "required": True,
     "source": "paper", "one_way": 6.5},
    {"name": "when", "column": "wave_height_m", "reduce": "time_of_max", "reference": 1.0,
     "tolerance_absolute": 0.5, "source": "paper"},
    {"name": "late", "column": "wave_height_m", "reduce": "final", "reference": 0.0,
     "tolerance_absolute": 1.0, "source": "paper"},
    {"name": "lost", "column": "no_such_column", "reference": 1.0, "tolerance": 0.1, "source": "paper"},
]


class Report(unittest.TestCase):
    def setUp(self) -> None:
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.run_dir = Path(holder.name)
        self.write_case(TARGETS)
        rows = ["window,time_s,wave_height_m,air_m", "0,0,0,nan", "1,1,9,2", "2,2,5,1", "3,3"]
        (self.run_dir / "history.csv").write_text("\n".join(rows) + "\n")

    def write_case(self, targets: list[dict]) -> None:
        case = {"case": {"name": "made_up", "title": "A <made-up> run", "end_time": 2.0},
                "physics": {"gravity": [0, 0, -9.81]}, "target": targets, "parameters": {"rho": 1000.0},
                "run": {"variant": "quick", "ranks_fluid": 2, "ranks_dem": 1, "version": "v"}}
        (self.run_dir / "case.toml").write_text(toml_out.dumps(case))

    def write_particles(self) -> None:
        entries = []
        for k, time in enumerate((0.0, 1.0, 2.0)):
            rows = [(0.5 + 0.2 * k, 0.5, 0.8 - 0.3 * k, 1, 0.1, 0), (0.9, 0.5, 0.2, 2, 0.1, 3)]
            handmade.write_particles(self.run_dir / f"dem/particles_{k}.vtk", rows)
            entries.append({"name": f"particles_{k}.vtk", "time": time})
        (self.run_dir / "dem/particles.vtk.series").write_text(json.dumps({"files": entries}))

    def write_fluid(self, two: bool) -> None:
        parts = [self.run_dir / f"fluid/processor{k}" for k in (0, 1)] if two else [self.run_dir / "fluid"]
        for number, part in enumerate(parts):
            handmade.write_mesh(part, binary=two, shift=2.0 * number)
            for time in ("0", "1", "2"):
                handmade.write_field(part / time / "U", [(0.0, 0.0, 1.0), (3.0, 0.0, 4.0)], two)
                if two:
                    handmade.write_field(part / time / "alpha.water", [1.0, 0.5 * number], True)
                    handmade.write_field(part / time / "eps", [0.4, 1.0], True)

    def page(self) -> str:
        report.finish(self.run_dir, {"prepare_s": 1.5}, 0)
        report.build(self.run_dir)
        return (self.run_dir / "report.html").read_text()

    def test_targets(self) -> None:
        summary = report.finish(self.run_dir, {"prepare_s": 1.5}, 0)
        rows = {t["name"]: t for t in json.loads((self.run_dir / "summary.json").read_text())["targets"]}
        self.assertEqual((rows["height"]["value"], rows["height"]["pass"]), (9.0, True))
        self.assertAlmostEqual(rows["height"]["relative_error"], 0.1)
        self.assertEqual((rows["when"]["value"], rows["when"]["unit"], rows["when"]["pass"]), (1.0, "s", True))
        self.assertEqual((rows["late"]["value"], rows["late"]["relative_error"], rows["late"]["pass"]),
                         (5.0, None, False))
        self.assertEqual((rows["lost"]["value"], rows["lost"]["pass"]), (None, False))
        self.assertEqual((summary["status"], summary["variant"], summary["prepare_s"]),
                         ("completed", "quick", 1.5))
        names = {q["name"]: (q["value"], q["unit"]) for q in summary["quantities"]}
        self.assertEqual((names["max_air_m"], names["air_m"]), ((2.0, "m"), (1.0, "m")))

    def test_targets_of_a_side_that_does_not_run_are_left_out(self) -> None:
        case = {"observe": {"wave": {"type": "wave"}, "slide": {"type": "slide"}}, "fluid": {"engine": "none"}}
        asked = [results.applies({"column": name}, case)
                 for name in ("wave_height_m", "slide_speed_m_s", "kinetic_energy_J")]
        self.assertEqual(asked, [False, True, True])
        self.assertTrue(results.applies({"column": "wave_height_m"}, case | {"fluid": {}}))

    def test_target_up_to_a_time(self) -> None:
        history = {"time_s": np.array([0.0, 1, 2, 3]), "v_m_s": np.array([1.0, 5, 2, 9])}
        target = {"name": "first peak", "column": "v_m_s", "reference": 5.0, "tolerance": 0.1, "source": "here"}
        self.assertEqual(results.judge({**target, "until": 2.5}, history)["value"], 5.0)
        self.assertEqual(results.judge(target, history)["value"], 9.0)

    def test_failure_takes_its_reason_from_the_programs(self) -> None:
        (self.run_dir / "failure.txt").write_text("dem rank 0 of 1: NaN\n")
        summary = report.finish(self.run_dir, {}, 1)
        self.assertEqual((summary["status"], summary["reason"]), ("failed", "dem rank 0 of 1: NaN"))

    def test_units(self) -> None:
        for column, unit in (("v_m_s", "m/s"), ("wave_height_m", "m"), ("j_kg_m_s", "kg m/s"), ("x", "")):
            self.assertEqual(results.unit_of(column), unit)
        self.assertEqual(results.plain_name("wave_speed_m_s"), "wave speed")

    def test_page_is_self_contained(self) -> None:
        self.write_fluid(two=True)
        self.write_particles()
        page = self.page()
        self.assertIn("A &lt;made-up&gt; run", page)
        self.assertIn("data:image/png;base64,", page)
        self.assertGreaterEqual(page.count("<svg"), 1)
        self.assertFalse(re.findall(r"(?:src|href)=[\"'](?!data:|#)", page.replace("xlink:href=\"#", "")))
        self.assertIn("one-way run", page)

    def test_two_fluids_in_two_parts(self) -> None:
        self.write_fluid(two=True)
        self.write_particles()
        meshes = section_plot._meshes(self.run_dir)
        plane = section_data.choose_plane([0, 0, -9.81], np.array([[0, 0, 0], [4, 1, 1.0]]))
        self.assertEqual((plane.along, plane.up, plane.normal), (0, 2, 1))
        frames, kind = section_data.frames(self.run_dir, plane, meshes, 0.5, 2)
        self.assertEqual((kind, [f.time_s for f in frames]), ("alpha.water", [0.0, 2.0]))
        np.testing.assert_allclose(np.concatenate(frames[1].values), [0.4, 0.0, 0.4, 0.5])
        self.assertEqual(frames[0].polygons[0].shape, (2, 4, 2))
        corners = {tuple(c) for c in frames[0].polygons[1][1]}
        self.assertEqual(corners, {(3.0, 0.0), (4.0, 0.0), (4.0, 1.0), (3.0, 1.0)})
        self.assertEqual(len(frames[0].particles.positions), 2)
        ends = {tuple(map(tuple, line)) for part in frames[0].walls for line in part}
        self.assertEqual(ends, {((0, 0), (0, 1)), ((2, 0), (2, 1)), ((4, 0), (4, 1))})

    def test_one_fluid_shows_speed(self) -> None:
        self.write_fluid(two=False)
        meshes = section_plot._meshes(self.run_dir)
        plane = section_data.Plane(0, 2, 1)
        frames, kind = section_data.frames(self.run_dir, plane, meshes, 0.5, 9)
        self.assertEqual(kind, "U")
        np.testing.assert_allclose(frames[0].values[0], [1, 5])
        self.assertIn("speed", self.page())

    def test_dry_run_and_nothing_at_all(self) -> None:
        self.assertIn("No fields and no particles", self.page())
        self.write_particles()
        self.assertIn("data:image/png", self.page())

    def test_one_particle_in_one_picture(self) -> None:
        self.write_particles()
        handmade.write_particles(self.run_dir / "dem/particles_0.vtk", [(0.5, 0.5, 0.8, 1, 0.1, 0)])
        (self.run_dir / "dem/particles.vtk.series").write_text(
            json.dumps({"files": [{"name": "particles_0.vtk", "time": 0.0}]}))
        self.assertIn("<svg", self.page())

    def test_torn_field_is_told_not_raised(self) -> None:
        self.write_fluid(two=False)
        path = self.run_dir / "fluid/1/U"
        path.write_bytes(path.read_bytes()[:-120])
        self.assertIn("Cannot be drawn", self.page())


if __name__ == "__main__":
    unittest.main()
