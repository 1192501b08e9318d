"""Makes settling.svg: speed of the sphere over its undisturbed terminal speed, run by run.

    PYTHONPATH=. python3 cases/settling_sphere/picture.py RUN_DIR... (from the top of the source tree)
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from launch import results
from launch.case import read_toml
from tests.cases.settling_ode import Sphere


def main(directories: list[Path]) -> None:
    drawing = Figure(figsize=(6.4, 3.4), layout="constrained")
    axes = drawing.add_subplot()
    for directory in directories:
        case, history = read_toml(directory / "case.toml"), results.read_history(directory)
        names = ("diameter", "solid_density", "fluid_density", "fluid_viscosity")
        sphere = Sphere(*(case["parameters"][n] for n in names))
        terminal = sphere.terminal_speed()
        response_s = sphere.mass * terminal / sphere.submerged_weight
        time = history["time_s"]
        shown = np.unique(np.geomspace(1, len(time) - 1, 40).astype(int))
        dots = axes.plot(time[shown] / response_s, -history["sphere_vz_m_s"][shown] / terminal, ".",
                         markersize=5, label=case["run"]["variant"])[0]
        fine = np.geomspace(0.02 * response_s, time[-1], 200)
        axes.plot(fine / response_s, sphere.speed(fine) / terminal, color=dots.get_color(),
                  linewidth=0.8)
    axes.set_xscale("log")
    axes.set(xlim=(0.02, None), xlabel="time / response time m/K", ylabel="speed / terminal speed",
             title="Coupled runs (dots), the equation of motion alone (lines)")
    axes.grid(alpha=0.3)
    axes.legend()
    drawing.savefig(Path(__file__).with_name("settling.svg"), metadata={"Date": None})


main([Path(word) for word in sys.argv[1:]])
