"""Prints LAMMPS' speed beside LIGGGHTS' (packaged law, and slidewave's own): a collapsing column of 5000
spheres, dry, one rank each, as slidewave runs them. Particle-steps per second of CPU time between a short and a
long run, so that start-up does not count; runs alternate, a ratio is that of neighbours in time.

  python3 tests/dem_lammps/speed.py BUILD [REPEATS]
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scenes

SHORT_S, LONG_S, STEP_S = 0.1, 0.4, 1e-4
RUNS = {  # shown name: dem.engine, whether slidewave's own contact law, program
    "LIGGGHTS": ("liggghts", False, "slidewave_dem"),
    "own law": ("liggghts", True, "slidewave_dem"),
    "LAMMPS": ("lammps", False, "slidewave_lammps"),
}
CASE = """[case]
name = "speed"
end_time = {end}
[coupling]
window = 0.02
[physics]
gravity = [0, 0, -9.81]
[fluid]
engine = "none"
[dem]
engine = "{engine}"
script = "dem/in.setup"
[parameters]
dem_dt = {step}
"""


def cpu_s(build: Path, name: str, end_s: float) -> float:
    """CPU time of one run [s], mpirun's own included."""
    engine, own_law, program = RUNS[name]
    with tempfile.TemporaryDirectory() as place:
        directory = Path(place)
        (directory / "dem").mkdir()
        scene = scenes.column(1, 25, 8, 25)
        (directory / "dem/spheres.data").write_text(scene.data())
        (directory / "dem/in.setup").write_text(scene.script(engine, own_law))
        (directory / "case.toml").write_text(CASE.format(end=end_s, engine=engine, step=STEP_S))
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(["mpirun", "--bind-to", "none", "-np", "1", build / "bin" / program, directory],
                       check=True, stdout=subprocess.DEVNULL, env={
                           **os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def speed(build: Path, name: str) -> float:
    """Million particle-steps per CPU second."""
    steps = 5e-3 * (LONG_S - SHORT_S) / STEP_S
    return steps / (cpu_s(build, name, LONG_S) - cpu_s(build, name, SHORT_S))


def main() -> None:
    build, repeats = Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 5
    ratios: dict[str, list[float]] = {name: [] for name in RUNS}
    print("million particle-steps per CPU second: " + ", ".join(RUNS))
    for _ in range(repeats):
        row = {name: speed(build, name) for name in RUNS}
        print("  ".join(f"{value:6.2f}" for value in row.values()))
        for name, value in row.items():
            ratios[name].append(value / row["LIGGGHTS"])
    for name, values in ratios.items():
        print(f"{name} over LIGGGHTS: median {statistics.median(values):.2f}")


if __name__ == "__main__":
    main()
