"""Runs the two fake engines as one MPMD job in a fresh run directory and checks how it ends.

    pair.py TEST --bin DIR --work DIR --mpirun "mpirun ..."

Each test is a function below. The fakes live in DIR; a run directory is made per run under work.
"""

import argparse
import csv
import json
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

CASE = """
[case]
name = "fakes"
end_time = {end_time}
[coupling]
window = {window}
scheme = "{scheme}"
smoothing_length = 0.1
patience = {patience}
reaction = "{reaction}"
regime = "{regime}"
outside = "{outside}"
[models]
drag = "{drag}"
[physics]
gravity = [0.0, 0.0, -9.81]
[fluid]
engine = "{fluid_engine}"
[dem]
engine = "fake"
[parameters]
cells = 12
length = 2.0
fluid_density = 1000.0
fluid_velocity = {fluid_velocity}
viscosity = {viscosity}
particles = {particles}
radius = 0.02
particle_density = 2650.0
fault = "{fault}"
"""
DEFAULTS = dict(end_time=0.2, window=0.01, patience=30.0, reaction="two_way", regime="mild", scheme="serial",
                outside="error", drag="di_felice", fluid_engine="fake", particles=500, fault="", viscosity=0.001,
                fluid_velocity=0.5)


class Run:
    """One finished job: status, output, seconds, and the files it left."""

    def __init__(self, options, name, fluid=2, dem=3, case=None, fluid_program="fake_fluid", signal_at_row=0,
                 dem_program="fake_dem", **values):
        self.directory = options.work / name
        shutil.rmtree(self.directory, ignore_errors=True)
        self.directory.mkdir(parents=True)
        (self.directory / "case.toml").write_text(case or CASE.format(**{**DEFAULTS, **values}))
        programs = []
        for count, program in ((fluid, fluid_program), (dem, dem_program)):
            if count:
                programs.append(["-np", str(count), str(options.bin / program), str(self.directory)])
        line = shlex.split(options.mpirun) + programs[0]
        for program in programs[1:]:
            line += [":"] + program
        start = time.monotonic()
        job = subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if signal_at_row:
            self.send_when(job, signal.SIGUSR1, signal_at_row)
        self.output, _ = job.communicate(timeout=60)
        self.seconds = time.monotonic() - start
        self.status = job.returncode

    def send_when(self, job, number, rows):
        """Signals mpirun, which hands it to all ranks, once history.csv has so many rows."""
        history = self.directory / "history.csv"
        while job.poll() is None:
            if history.exists() and history.read_text().count("\n") > rows:
                job.send_signal(number)
                return
            time.sleep(0.01)

    def rows(self):
        with open(self.directory / "history.csv", newline="") as file:
            return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]

    def summary(self):
        return json.loads((self.directory / "summary.json").read_text())

    def must_pass(self):
        assert self.status == 0, f"status {self.status}:\n{self.output}"
        return self

    def must_fail(self, status, *texts):
        """Both programs ended in time, with this status and these words on the terminal."""
        assert self.status == status, f"status {self.status}, not {status}:\n{self.output}"
        assert self.seconds < 10, f"took {self.seconds:.1f} s"
        for text in texts:
            assert text in self.output, f"'{text}' is not in:\n{self.output}"
        if texts:
            record = (self.directory / "failure.txt").read_text()
            assert texts[0] in record, record
            lines = [line for line in self.output.splitlines() if line.startswith("slidewave: ")]
            assert len(lines) == 1, f"the reason should be told once:\n{self.output}"
        return self


def budgets(options):
    """Two-way momentum, volume and pressure budgets close to round-off, for several rank counts."""
    rows = []
    for fluid, dem in ((1, 1), (2, 3), (3, 2)):
        run = Run(options, f"budgets_{fluid}_{dem}", fluid, dem).must_pass()
        summary = run.summary()
        found = summary["budgets"]
        assert found["momentum_defect"] < 1e-12, found
        assert found["solid_volume_defect"] < 1e-12, found
        assert found["pressure_defect"] < 1e-12, found
        assert found["momentum_outstanding"] < 1e-2, found
        assert found["particles_lost"] == 0 and found["outside_max"] == 0, found
        assert summary["status"] == "completed" and summary["windows"] == 20
        assert summary["particles"] == 500 and summary["cells"] == 12
        assert summary["ranks"] == {"fluid": fluid, "dem": dem}
        assert summary["bytes_per_particle"] == 176
        assert set(summary["timings"]["dem"]) == {"solve", "exchange", "wait", "locate",
                                                  "void_fraction", "force"}
        rows.append(run.rows())
    assert [row["time_s"] for row in rows[0]][:3] == [0, 0.01, 0.02] and len(rows[0]) == 21
    # Drag has really acted: fluid and particles have exchanged more than they still owe.
    assert abs(sum(row["received_x_kg_m_s"] for row in rows[0])) > 1
    for other in rows[1:]:  # any number of ranks, same numbers
        for one, two in zip(rows[0], other):
            for key in one:
                if not key.endswith("_defect"):
                    assert abs(one[key] - two[key]) <= 1e-9 * max(1, abs(one[key])), (key, one, two)


def broken_budgets(options):
    """A cell, a rank, a sub-step or a particle that is dropped once shows in a budget."""
    for fault in ("drop_cell", "drop_rank", "drop_substep"):
        found = Run(options, fault, fault=fault).must_pass().summary()["budgets"]
        assert found["momentum_defect"] > 1e-6, (fault, found)
    found = Run(options, "lose_particle", fault="lose_particle").must_pass().summary()["budgets"]
    assert found["particles_lost"] == 1 and found["mass_lost_kg"] > 0.08, found
    assert found["momentum_defect"] > 1e-7, found
    found = Run(options, "drop_volume", fault="drop_volume").must_pass().summary()["budgets"]
    assert found["solid_volume_defect"] > 1e-3 and found["pressure_defect"] > 1e-3, found


def stiff(options):
    """K W/m of 1 to 300 in the stiff regime: budgets close, fluid and particles come to one velocity
    (but for gravity), on any number of ranks; a budget still sees what is dropped."""
    rows = []
    for viscosity in (10.0, 3000.0):
        for fluid, dem in ((1, 1), (2, 3)):
            run = Run(options, f"stiff_{viscosity:g}_{fluid}_{dem}", fluid, dem, regime="stiff",
                      viscosity=viscosity).must_pass()
            summary = run.summary()
            assert summary["budgets"]["momentum_defect"] < 1e-12, summary["budgets"]
            assert summary["bytes_per_particle"] == 240, summary["bytes_per_particle"]
            assert "stiff regime" in [feature["name"] for feature in summary["active"]]
            rows.append(run.rows())
    for one, two in zip(rows[0] + rows[2], rows[1] + rows[3]):
        for key in one:
            if not key.endswith("_defect"):
                assert abs(one[key] - two[key]) <= 1e-9 * max(1, abs(one[key])), (key, one, two)
    for fault in ("drop_cell", "drop_rank", "drop_substep"):
        found = Run(options, "stiff_" + fault, fault=fault, regime="stiff",
                    viscosity=10.0).must_pass().summary()["budgets"]
        assert found["momentum_defect"] > 1e-6, (fault, found)
    Run(options, "stiff_held", fault="partly_held", regime="stiff").must_fail(2, "coupling.regime", "held along z")
    Run(options, "mild_held", fault="partly_held").must_pass()


def concurrent(options):
    """Both sides at once: the same budgets on any ranks, errors of first order in the window against the
    serial scheme's limit, half the time where both sides take as long, and slips that ring beyond
    exp(-K W/m) = K W/m_fluid. A budget still sees what is dropped."""
    rows = []
    for fluid, dem in ((1, 1), (2, 3)):
        run = Run(options, f"concurrent_{fluid}_{dem}", fluid, dem, scheme="concurrent").must_pass()
        found = run.summary()["budgets"]
        for name in ("momentum_defect", "solid_volume_defect", "pressure_defect"):
            assert found[name] < 1e-12, found
        assert run.summary()["scheme"] == "concurrent"
        rows.append(run.rows())
    for one, two in zip(*rows):
        for key in one:
            if not key.endswith("_defect"):
                assert abs(one[key] - two[key]) <= 1e-9 * max(1, abs(one[key])), (key, one, two)
    for fault in ("drop_cell", "drop_rank", "drop_substep"):
        found = Run(options, "concurrent_" + fault, fault=fault, scheme="concurrent").must_pass().summary()["budgets"]
        assert found["momentum_defect"] > 1e-6, (fault, found)

    def exchanged(scheme, window):
        run = Run(options, f"order_{scheme}_{window:g}", 1, 1, scheme=scheme, window=window, viscosity=1.0)
        return sum(row["received_x_kg_m_s"] for row in run.must_pass().rows())

    limit = 2 * exchanged("serial", 6.25e-4) - exchanged("serial", 1.25e-3)
    errors = [abs(exchanged("concurrent", window) / limit - 1) for window in (0.01, 0.005, 0.0025)]
    assert errors[0] < 0.05, errors
    for coarse, fine in zip(errors, errors[1:]):
        assert 1.7 < coarse / fine < 2.4, errors

    wall_s = {scheme: Run(options, "slow_" + scheme, 1, 1, scheme=scheme, fault="slow", end_time=0.1).must_pass()
              .summary()["wall_s"] for scheme in ("serial", "concurrent")}
    assert wall_s["concurrent"] < wall_s["serial"] - 1.2, wall_s  # 10 windows of 2 x 200 ms

    ringing = Run(options, "ringing", 1, 1, scheme="concurrent", viscosity=700.0).must_pass().rows()
    signs = [row["received_x_kg_m_s"] > 0 for row in ringing[1:7]]
    assert signs == [True, False] * 3, signs
    Run(options, "both", scheme="concurrent", regime="stiff").must_fail(2, "coupling.scheme", "mild regime")


def one_way(options):
    """Without reaction no ledger, no porosity: smaller messages, and the fluid feels nothing."""
    run = Run(options, "one_way", reaction="one_way").must_pass()
    summary = run.summary()
    assert summary["bytes_per_particle"] == 128, summary["bytes_per_particle"]
    assert "momentum_defect" not in summary["budgets"] and "given_x_kg_m_s" not in run.rows()[0]
    assert "porosity" in [feature["name"] for feature in summary["left_out"]]
    run = Run(options, "no_drag", drag="none", reaction="one_way").must_pass()
    assert run.summary()["bytes_per_particle"] == 72, run.summary()["bytes_per_particle"]


def dry(options):
    """fluid.engine = "none": the particle side runs alone; a fluid process is refused."""
    summary = Run(options, "dry", fluid=0, dem=2, fluid_engine="none").must_pass().summary()
    assert summary["ranks"] == {"fluid": 0, "dem": 2} and summary["windows"] == 20, summary
    assert summary["bytes_per_particle"] == 0
    Run(options, "dry_unwanted", fluid_engine="none").must_fail(2, "wants no fluid")


def empty(options):
    """No particles at all is a run like any other."""
    summary = Run(options, "empty", particles=0).must_pass().summary()
    assert summary["budgets"]["momentum_defect"] == 0 and summary["particles"] == 0


def last_window(options):
    """The last window ends exactly at the end of the case, and a remainder of round-off is none."""
    rows = Run(options, "remainder", end_time=0.035, window=0.01).must_pass().rows()
    assert [row["time_s"] for row in rows] == [0, 0.01, 0.02, 0.03, 0.035]
    rows = Run(options, "round", end_time=0.3, window=0.1).must_pass().rows()
    assert [row["time_s"] for row in rows] == [0, 0.1, 0.2, 0.3]


def stopped(options):
    """A signal to one process of either side stops both at the same window, cleanly."""
    for side in ("fluid", "dem"):
        run = Run(options, side + "_signalled", fault=side + "_signalled", end_time=2.0).must_pass()
        summary = run.summary()
        assert summary["status"] == "stopped" and 20 <= summary["windows"] <= 22, summary
        assert len(run.rows()) == summary["windows"] + 1
        assert summary["budgets"]["momentum_defect"] < 1e-12
    run = Run(options, "all_signalled", signal_at_row=10, end_time=100.0).must_pass()
    assert run.summary()["status"] == "stopped" and run.summary()["windows"] < 10000


def engine_failures(options):
    """However one side ends, the other ends with it, and the reason is told."""
    for side in ("fluid", "dem"):
        Run(options, side + "_throws", fault=side + "_throws").must_fail(
            1, f"the {side} engine broke on purpose", f"{side} rank")
        Run(options, side + "_exits", fault=side + "_exits").must_fail(1, "called exit()")
        Run(options, side + "_vanishes", fault=side + "_vanishes").must_fail(1)
        killed = Run(options, side + "_is_killed", fault=side + "_is_killed")
        assert killed.status != 0 and killed.seconds < 10 and "Killed" in killed.output, killed.output


def stall(options):
    """A side that never answers is given up after the patience, naming who waited for whom."""
    Run(options, "fluid_stalls", fault="fluid_stalls", patience=2.0).must_fail(
        1, "dem rank", "longer than coupling.patience", "for fluid rank")
    Run(options, "dem_stalls", fault="dem_stalls", patience=2.0).must_fail(
        1, "fluid rank", "longer than coupling.patience", "for dem")


def bad_numbers(options):
    """A number that is none is caught in the exchange, with the field and the place."""
    Run(options, "dem_nan", fault="dem_nan").must_fail(
        1, "'velocity' of the particle at (", "is not a finite number")
    Run(options, "fluid_nan", fault="fluid_nan").must_fail(
        1, "'fluid_velocity' for the particle at (", "is not a finite number")


def outside(options):
    """A particle far outside is the case's choice; one that touches the wall is only counted."""
    Run(options, "outside_error", fault="fall_out").must_fail(
        1, "outside the fluid mesh at window 5", "-0.5) m", "coupling.outside")
    for policy in ("warn", "ignore"):
        run = Run(options, "outside_" + policy, fault="fall_out", outside=policy).must_pass()
        assert ("warning: " in run.output) == (policy == "warn"), run.output
        found = run.summary()["budgets"]
        assert found["outside_max"] == 3 and found["momentum_defect"] < 1e-12, found
    found = Run(options, "touch_wall", fault="touch_wall").must_pass().summary()["budgets"]
    assert found["nearest_cell_max"] == 3 and found["outside_max"] == 0, found
    assert found["momentum_defect"] < 1e-12 and found["solid_volume_defect"] < 1e-12, found


def air(options):
    """In air a particle keeps its ledger; back in the water it is repaid. The budget holds throughout."""
    run = Run(options, "air", fluid_program="fake_air", outside="warn").must_pass()
    found = run.summary()["budgets"]
    assert found["momentum_defect"] < 1e-12, found
    kept = [row["ledger_in_air_kg_m_s"] for row in run.rows()]
    assert max(kept) > 1e-4, kept
    rows = run.rows()
    total = [abs(row["ledger_z_kg_m_s"]) for row in rows]
    # The ledger is not lost in air: while it is kept there, the total holds at least as much.
    assert all(t > 0 for t in total[3:]), total
    water = Run(options, "water").must_pass()
    assert max(row["ledger_in_air_kg_m_s"] for row in water.rows()) == 0


def allocations(options):
    """A window of the steady state allocates nothing; the first rank of each side, which writes the
    files, nothing that grows with the particles. Still water: no particle crosses to another rank."""
    for regime in ("mild", "stiff"):
        run = Run(options, "allocations_" + regime, fluid_program="counted_fluid", dem_program="counted_dem",
                  particles=4000, fluid_velocity=0.0, regime=regime)
        run.must_pass()
        lines = (run.directory / "allocations.txt").read_text().split("\n")[:-1]
        assert len(lines) == 5, lines
        for line in lines:
            _, rank, times, largest = line.split()
            assert int(times) == 0 if rank != "0" else int(largest) < 4096, lines


def uniform_flow(options):
    """The prescribed fluid: any number of ranks, its own columns; what it cannot do is refused."""
    program = (options.bin / "../bin/slidewave_uniform").resolve()
    text = CASE.format(**{**DEFAULTS, "reaction": "one_way", "end_time": 0.05})
    flow = """[uniform_flow]
density = 1000.0
viscosity = 0.001
amplitude = [0.3, 0.0, 0.0]
period = 0.2
"""

    def run(name, more="", fluid=1, case=text):
        return Run(options, name, fluid, 2, case=case + flow + more, fluid_program=program)

    rows = run("uniform", fluid=2).must_pass().rows()
    assert abs(rows[-1]["flow_vx_m_s"] - 0.3) < 1e-9 and len(rows) == 6, rows
    run("uniform_strain", "gradient_u = [2, 0, 0]\ngradient_w = [0, 0, -2]").must_pass()
    run("uniform_squeezed", "gradient_u = [2, 0, 0]").must_fail(2, "uniform_flow.gradient_u", "trace")
    run("uniform_twisted", "gradient_u = [0, 1, 0]\ngradient_v = [0, 0, 1]").must_fail(2, "symmetric")
    run("uniform_two_way", case=text.replace("one_way", "two_way")).must_fail(
        2, "coupling.reaction", "takes no momentum")


def missing_role(options):
    """One program alone is refused at once, and the missing one is named."""
    Run(options, "no_dem", dem=0).must_fail(2, "role 'dem' is missing", "slidewave_dem")
    Run(options, "no_fluid", fluid=0).must_fail(2, "role 'fluid' is missing", "slidewave_foam")


def bad_input(options):
    """What a user can mend: status 2, with file, key, value and remedy."""
    Run(options, "mismatch", fault="gravity").must_fail(2, "disagree", "gravity", "0 0 -1 ", "-9.81")
    Run(options, "negative", window=-1.0).must_fail(2, "case.toml: coupling.window = -1", "positive")
    Run(options, "unknown", drag="di_felise").must_fail(2, "models.drag = \"di_felise\"", "\"none\"")
    Run(options, "not_toml", case="[case\n").must_fail(2, "line 1", "not valid TOML")
    Run(options, "no_offer", fault="no_density").must_fail(
        2, "the model 'drag' needs the field 'density'")


def main():
    tests = {name: test for name, test in globals().items()
             if callable(test) and getattr(test, "__doc__", None) and name not in ("Run", "main")
             and not name.startswith("_") and test.__module__ == __name__}
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("test", choices=sorted(tests))
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--mpirun", required=True)
    options = parser.parse_args()
    tests[options.test](options)


if __name__ == "__main__":
    sys.exit(main())
