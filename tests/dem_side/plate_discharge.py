"""Angle of repose: a bed on a plate is let flow over both edges of it, as Zhou, Xu, Yu & Zulli did (2002,
Powder Technology 125, 45-54). SI units.

Plate 30 diameters long, spheres of one size, the thickness periodic: their limit without front and rear
walls. The box ends at the edges: a sphere whose centre passes one is gone, as it would fall."""

from __future__ import annotations

import os
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

PROGRAM = os.environ.get("SLIDEWAVE_DEM", "slidewave_dem")
DIAMETER_M, DENSITY = 0.01, 2500  # glass beads
PLATE = 30  # length over the diameter
MU_PAIR, MU_WALL = 0.4, 0.6  # their base condition

SCRIPT = """units si
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
processors * 1 1
read_data loose.data
neighbor 0.003 bin
neigh_modify delay 0
pair_style gran model linear tangential coulomb {model} kn 1e4 damping 0.25 ks 8e3 mu {mu_pair} {rolling}
pair_coeff * *
fix plate all wall/gran model linear tangential coulomb {model} primitive type 1 zplane 0 &
  kn 1e4 damping 0.25 ks 8e3 mu {mu_wall} {rolling}
fix left all wall/gran model linear primitive type 1 xplane {low} kn 1e4 damping 0.25
fix right all wall/gran model linear primitive type 1 xplane {high} kn 1e4 damping 0.25
fix weight all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
timestep 6e-5
thermo_modify lost ignore
run 10000
unfix left
unfix right
run {flow}
variable joules equal ke
print "kinetic energy ${{joules}} J"
dump end all custom 1 end.dump id x z radius
run 0
"""


@dataclass
class Heap:
    """Slope of both flanks [degrees], spheres left on the plate, kinetic energy [J], seconds of wall."""

    angle: float
    spheres: int
    kinetic_J: float
    wall_s: float


def discharge(place: Path, rolling: str, thickness: float = 4, flow_s: float = 3) -> Heap:
    """The heap that stays on the plate. `rolling`: model and constants, e.g. "iwashita_oda kr 0.05 eta 0.1",
    or nothing; `thickness` in diameters."""
    start = time.monotonic()
    half = PLATE / 2 * DIAMETER_M
    _write_bed(place / "loose.data", thickness)
    model, constants = rolling.split(" ", 1) if rolling else ("", "")
    text = SCRIPT.format(model=f"rolling_friction {model}" if model else "", rolling=constants, low=-half, high=half,
                         mu_pair=MU_PAIR, mu_wall=MU_WALL, flow=round(flow_s / 6e-5))
    (place / "in.plate").write_text(text)
    done = subprocess.run([PROGRAM, "--script", "in.plate", "-log", "none"], cwd=place,
                          capture_output=True, text=True, check=False, timeout=1800)
    if done.returncode:
        raise RuntimeError(done.stdout[-1500:])
    rows = (place / "end.dump").read_text().rsplit("ITEM: ATOMS", 1)[1].split("\n", 1)[1].split()
    heap = np.array(rows, dtype=float).reshape(-1, 4)
    kinetic_J = float(done.stdout.split("kinetic energy ")[-1].split()[0])
    return Heap(_slope(heap, half), len(heap), kinetic_J, time.monotonic() - start)


def zhou(eta: float) -> float:
    """Angle of repose [degrees] of Zhou et al. 2002, their fit without front and rear walls. Their
    coefficient of rolling friction is the lever of the limit moment in mm: eta times the reduced
    radius, half a radius between two spheres, a radius at a wall."""
    radius_mm = 1e3 * DIAMETER_M / 2
    return (68.61 * MU_PAIR**0.27 * MU_WALL**0.22 * (eta * radius_mm / 2)**0.06 * (eta * radius_mm)**0.12
            * (2 * radius_mm)**-0.2)


def _write_bed(file: Path, thickness: float) -> None:
    """Half as high as the plate is long, in loose layers, shaken."""
    d, count = DIAMETER_M, round(0.6 * PLATE * thickness * PLATE / 2 / (np.pi / 6))
    across, along = max(1, int(thickness / 1.1)), int(PLATE / 1.1)
    row, column = np.divmod(np.arange(count), across * along)
    shaken = np.random.default_rng(5).uniform(-0.05, 0.05, (count, 3))
    places = d * (np.column_stack([(column // across + 0.5) * PLATE / along - PLATE / 2,
                                   (column % across + 0.5) * thickness / across, 0.6 + 1.1 * row]) + shaken)
    rows = "".join(f"{n + 1} 1 {d} {DENSITY} {x:.10g} {y:.10g} {z:.10g}\n" for n, (x, y, z) in enumerate(places))
    top, side = places[:, 2].max() + 2 * d, PLATE / 2 * d
    file.write_text(f"bed\n\n{count} atoms\n1 atom types\n\n{-side} {side} xlo xhi\n0 {thickness * d} ylo yhi\n"
                    f"{-d} {top} zlo zhi\n\nAtoms\n\n{rows}")


def _slope(heap: np.ndarray, half_m: float) -> float:
    """Mean of both flanks: line through the tops of columns a diameter wide, 15 to 85 % of the way out."""
    slopes = []
    for side in (-1, 1):
        out = side * heap[:, 1]
        edges = np.arange(0.15 * half_m, 0.85 * half_m, DIAMETER_M)
        tops = [(low + DIAMETER_M / 2, heap[inside, 2].max()) for low in edges
                if (inside := (out >= low) & (out < low + DIAMETER_M)).any()]
        slopes.append(-np.polyfit(*np.transpose(tops), 1)[0] if len(tops) > 2 else 0.0)
    return float(np.degrees(np.arctan(np.mean(slopes))))
