"""Checkpoints and restarts of the two fake engines: a run that goes on is the run that did not stop.

    restarts.py TEST --bin DIR --work DIR --mpirun "mpirun ..." [--seeds N]
"""

import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

from pair import CASE, DEFAULTS, Run

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent))
from launch import mpirun_end

KEYS = "[checkpoint]\nwindows = 10\nkeep = 3\n"


def text(more=KEYS, **values):
    return CASE.format(**{**DEFAULTS, "end_time": 0.4, "outside": "ignore", **values}) + more


class Again(Run):
    """The same directory once more, or a copy of it, perhaps on other ranks."""

    def __init__(self, options, earlier, name=None, fluid=2, dem=3, case=None):
        self.directory = options.work / name if name else earlier.directory
        if name:
            shutil.rmtree(self.directory, ignore_errors=True)
            shutil.copytree(earlier.directory, self.directory)
        if case:
            (self.directory / "case.toml").write_text(case)
        self.options, self.ranks = options, (fluid, dem)

    def prepare(self, change):
        change(self.directory)
        return self

    def go(self):
        line = command(self.options, self.directory, *self.ranks)
        start = time.monotonic()
        done = subprocess.run(line, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60,
                              check=False)
        self.output, self.status, self.seconds = done.stdout, done.returncode, time.monotonic() - start
        return self


def command(options, directory, fluid=2, dem=3):
    return [*options.mpirun.split(), "-np", str(fluid), str(options.bin / "fake_fluid"), str(directory), ":",
            "-np", str(dem), str(options.bin / "fake_dem"), str(directory)]


def folder(directory, window):
    return directory / "checkpoints" / f"{window:08d}"


def drop(*windows):
    """Removes checkpoints, as if the run had ended before it wrote them."""
    return lambda directory: [shutil.rmtree(folder(directory, n)) for n in windows]


def same(one, other, window=40):
    """Every row, and every bit of the state at a window."""
    assert (one.directory / "history.csv").read_bytes() == (other.directory / "history.csv").read_bytes()
    pieces = [json.loads((folder(run.directory, window) / "manifest.json").read_text())["pieces"]
              for run in (one, other)]
    assert pieces[0] == pieces[1], pieces


def first(options, name, **values):
    return Run(options, name, case=text(**values)).must_pass()


def bit_for_bit(options):
    """From any checkpoint to the same end; the newest ones are kept, and torn directories removed."""
    whole = first(options, "whole")
    kept = sorted(p.name for p in (whole.directory / "checkpoints").iterdir())
    assert kept == ["00000020", "00000030", "00000040"], kept
    assert whole.summary()["restarts"] == 0
    for name, gone in (("from_20", (30, 40)), ("from_30", (40,)), ("from_the_end", ())):
        run = Again(options, whole, name).prepare(drop(*gone)).go().must_pass()
        assert "going on after window" in run.output and "not bit" not in run.output, run.output
        same(whole, run)
        found = run.summary()
        assert found["restarts"] == 1 and found["status"] == "completed" and found["windows"] == 40, found
        assert found["wall_s"] > whole.summary()["wall_s"], "wall time adds up"
    twice = Again(options, whole, "twice").prepare(drop(30, 40)).go().must_pass()
    twice.prepare(drop(40)).go().must_pass()
    same(whole, twice)
    assert twice.summary()["restarts"] == 2
    assert twice.summary()["budgets"] == whole.summary()["budgets"]


def one_way_and_dry(options):
    """Without a ledger, in the stiff regime, with both sides at once, and without a fluid."""
    for name, values in (("one_way", {"reaction": "one_way"}), ("stiff", {"regime": "stiff"}),
                         ("concurrent", {"scheme": "concurrent"})):
        whole = first(options, name, **values)
        same(whole, Again(options, whole, name + "_again").prepare(drop(40)).go().must_pass())
    dry = Run(options, "dry", fluid=0, dem=2, case=text(fluid_engine="none")).must_pass()
    rows = (dry.directory / "history.csv").read_bytes()
    drop(40)(dry.directory)
    line = [*options.mpirun.split(), "-np", "2", str(options.bin / "fake_dem"), str(dry.directory)]
    done = subprocess.run(line, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0 and "after window 30" in done.stdout, done.stdout + done.stderr
    assert (dry.directory / "history.csv").read_bytes() == rows


def uniform_flow(options):
    """The prescribed fluid, which moves in time, goes on too."""
    flow = "[uniform_flow]\ndensity = 1000.0\nviscosity = 0.001\namplitude = [0.3, 0.0, 0.0]\nperiod = 0.7\n"
    case = text(KEYS + flow, reaction="one_way")
    program = (options.bin / "../bin/slidewave_uniform").resolve()
    whole = Run(options, "uniform", 1, 2, case=case, fluid_program=program).must_pass()
    rows = (whole.directory / "history.csv").read_bytes()
    drop(30, 40)(whole.directory)
    line = [*options.mpirun.split(), "-np", "1", str(program), str(whole.directory), ":", "-np", "2",
            str(options.bin / "fake_dem"), str(whole.directory)]
    done = subprocess.run(line, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0 and "after window 20" in done.stdout, done.stdout + done.stderr
    assert (whole.directory / "history.csv").read_bytes() == rows


def other_ranks(options):
    """Any ranks go on; the run says that it is not bit for bit, and its budgets still close."""
    whole = first(options, "whole")
    for fluid, dem in ((1, 1), (3, 2), (2, 1), (1, 3)):
        run = Again(options, whole, f"on_{fluid}_{dem}", fluid, dem).prepare(drop(30, 40)).go().must_pass()
        assert f"on {fluid} + {dem} ranks instead of 2 + 3: not bit for bit" in run.output, run.output
        assert run.summary()["budgets"]["momentum_defect"] < 1e-12
        assert run.summary()["budgets"]["solid_volume_defect"] < 1e-12
        for one, two in zip(whole.rows(), run.rows(), strict=True):
            for key in one:
                if not key.endswith("_defect"):
                    assert abs(one[key] - two[key]) <= 1e-9 * max(1, abs(one[key])), (key, one, two)


def torn(options):
    """Whatever is wrong with the newest checkpoint is named, and the one before it taken."""
    whole = first(options, "whole")

    def change(window, name, how):
        def act(directory):
            file = folder(directory, window) / name
            data = file.read_bytes()
            file.write_bytes(how(data))
        return act

    def swap(directory):  # a mixture of two checkpoints: same names, same sizes
        shutil.copy(folder(directory, 30) / "dem.1", folder(directory, 40) / "dem.1")

    def flipped(data):
        return data[:600] + bytes([data[600] ^ 16]) + data[601:]

    for name, harm, word in (
            ("short", change(40, "dem.0", lambda d: d[:-100]), "dem.0 has"),
            ("empty", change(40, "fluid.1", lambda d: b""), "fluid.1 has 0 bytes"),
            ("missing", lambda d: (folder(d, 40) / "dem.2").unlink(), "dem.2 is missing"),
            ("flipped", change(40, "fluid.0", flipped), "fluid.0 is not what was written"),
            ("mixed", swap, "dem.1 is not what was written"),
            ("other", lambda d: shutil.copy(folder(d, 30) / "manifest.json", folder(d, 40)), "belongs to another"),
            ("torn_manifest", change(40, "manifest.json", lambda d: d[:50]), "manifest.json is damaged")):
        run = Again(options, whole, name).prepare(harm).go().must_pass()
        assert "window 40 is not used: " in run.output and word in run.output, run.output
        assert "going on after window 30" in run.output, run.output
        same(whole, run)
    run = Again(options, whole, "no_manifest").prepare(
        lambda d: [(folder(d, 40) / "manifest.json").unlink(), folder(d, 33).mkdir()]).go().must_pass()
    assert "going on after window 30" in run.output, run.output
    same(whole, run)
    assert len(list((run.directory / "checkpoints").iterdir())) == 3, "remains are removed"

    def all_torn(directory):
        for n in (20, 30, 40):
            (folder(directory, n) / "fluid.0").write_bytes(b"")
    run = Again(options, whole, "all").prepare(all_torn).go()
    assert run.status == 2 and "none of them is complete" in run.output, run.output
    Again(options, whole, "rows").prepare(lambda d: (d / "history.csv").write_text("window\n")).go().must_fail(2)


def another_scene(options):
    """Windows of another length are refused; another case is told."""
    whole = first(options, "whole")
    run = Again(options, whole, "window", case=text(window=0.02)).go()
    assert run.status == 2 and "coupling.window" in run.output, run.output
    run = Again(options, whole, "longer", case=text(end_time=0.5)).go().must_pass()
    assert "case.toml has changed" in run.output and len(run.rows()) == 51, run.output


def on_signal(options):
    """A signal leaves a checkpoint at the window where both sides stop; the rest of the run follows."""
    whole = first(options, "whole", end_time=2.0)
    for side in ("fluid", "dem"):
        case = text("", fault=side + "_signalled", end_time=2.0)
        run = Run(options, side, case=case).must_pass()
        last = run.summary()["windows"]
        assert run.summary()["status"] == "stopped" and 20 <= last <= 22
        assert [p.name for p in (run.directory / "checkpoints").iterdir()] == [f"{last:08d}"]
        again = Again(options, run, case=text("", end_time=2.0)).go().must_pass()
        assert again.summary()["status"] == "completed"
        assert (again.directory / "history.csv").read_bytes() == (whole.directory / "history.csv").read_bytes()


def by_wall_time(options):
    """checkpoint.interval counts wall time; at_end adds one at the end; without keys there is none."""
    run = Run(options, "interval", case=text("[checkpoint]\ninterval = 0.05\nkeep = 100\nat_end = true\n", end_time=3.0))
    run.must_pass()
    found = sorted(int(p.name) for p in (run.directory / "checkpoints").iterdir())
    assert len(found) >= 3 and found[-1] == 300, found
    assert not (Run(options, "none", case=text("")).must_pass().directory / "checkpoints").exists()


def unable(options):
    """An engine that cannot save its state: keys are refused, a signal just stops."""
    Run(options, "keys", case=text(fault="no_state")).must_fail(2, "the dem engine cannot save its state")
    run = Run(options, "signal", case=text("", end_time=100.0, fault="no_state"), signal_at_row=10).must_pass()
    assert run.summary()["status"] == "stopped" and not (run.directory / "checkpoints").exists()


def killed(options):
    """kill -9 of any process at any moment, again and again: the end is that of a run left alone."""
    whole = first(options, "whole", end_time=2.0)
    took, total = whole.seconds, 0
    for seed in range(options.seeds):
        chance = random.Random(seed)
        directory = options.work / f"seed_{seed}"
        shutil.rmtree(directory, ignore_errors=True)
        directory.mkdir(parents=True)
        (directory / "case.toml").write_text(text(end_time=2.0))
        kills = 0
        for attempt in range(20):
            status, hit = run_and_kill(command(options, directory), chance if attempt < 6 else None, took)
            kills += hit
            if status == 0:
                break
        assert status == 0, (seed, status)
        total += kills
        run = Again(options, whole)
        run.directory = directory
        same(whole, run, window=200)
        print(f"seed {seed}: killed {kills} times")
    assert total >= options.seeds, f"only {total} of the kills came in time"


def run_and_kill(line, chance, seconds):
    """Exit status, and whether a process was killed in time."""
    job = subprocess.Popen(line, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    hit = []

    def strike():
        try:
            pids = Path(f"/proc/{job.pid}/task/{job.pid}/children").read_text().split()
            os.kill(int(chance.choice(pids)), signal.SIGKILL)
            hit.append(1)
        except (OSError, IndexError):
            pass  # it has ended already
    timer = threading.Timer(chance.uniform(0.1, 0.8) * seconds, strike) if chance else None
    if timer:
        timer.start()
    status = mpirun_end.wait(job, timeout_s=60)  # None: it hung after its programs, as mpirun may where one was killed
    if timer:
        timer.cancel()
    return status, len(hit)


def main():
    tests = {name: test for name, test in globals().items()
             if callable(test) and getattr(test, "__code__", None) and test.__code__.co_varnames[:1] == ("options",)
             and test.__code__.co_argcount == 1}
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("test", choices=sorted(tests))
    parser.add_argument("--bin", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--mpirun", required=True)
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    tests[options.test](options)


if __name__ == "__main__":
    sys.exit(main())
