"""A dry column of spheres let go in a thin slab: run-out against Lajeunesse et al. 2005 and Lube et
al. 2005, slope against rolling resistance. Lengths in m, SI units.

Scene: width along y just over one diameter, periodic (own contact law), column of length L0 against
the wall x = 0, floor with the friction of the grains. With no intrinsic length but the grain's, results
go with H0/L0 and hardly with L0/D."""

from __future__ import annotations

import os
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

PROGRAM = os.environ.get("SLIDEWAVE_DEM", "slidewave_dem")

SCRIPT = """units si
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
processors * 1 1
read_data loose.data
neighbor {skin} bin
neigh_modify delay 0
pair_style gran model linear {laws} kn {kn} damping 0.2 ks {ks} mu {mu} {more}
pair_coeff * *
fix floor all wall/gran model linear {laws} primitive type 1 zplane 0 kn {kn} damping 0.2 ks {ks} mu {mu} {more}
fix back all wall/gran model linear primitive type 1 xplane 0 kn {kn} damping 0.2
fix gate all wall/gran model linear primitive type 1 xplane {length} kn {kn} damping 0.2
fix weight all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
timestep {dt}
run {settle}
fix slow all viscous {drag}
run {rest}
unfix slow
dump start all custom 1 start.dump id x z radius
run 0
undump start
unfix gate
run {flow}
dump end all custom 1 end.dump id x z radius
run 0
"""


@dataclass
class Outcome:
    """Run-out over initial length, H0/L0 as settled, slope of the deposit [degrees], seconds of wall."""

    run_out: float
    aspect: float
    slope: float
    wall_s: float
    spheres: int


def collapse(place: Path, aspect: float, length: float, diameter: float, mu: float = 0.5,
             rolling: str = "", stiffness: float = 1000, step: float = 0.2, seed: int = 3) -> Outcome:
    """Lets a column of about aspect = H0/L0 go. `length` is L0; `rolling` e.g. "shape 0.4 crushing 2.1";
    `stiffness`: kn over what presses a sphere flat by D under the column; `step` over sqrt(m/kn)."""
    start = time.monotonic()
    width, rng = 1.15 * diameter, np.random.default_rng(seed)
    columns = int(length / (1.05 * diameter))
    count = int(0.6 * aspect * length**2 * width / (np.pi / 6 * (0.9 * diameter)**3))
    row, column = np.divmod(np.arange(count), columns)
    sizes = diameter * rng.uniform(0.8, 1.0, count)
    shaken = 0.04 * diameter * rng.uniform(-1, 1, count) + 0.25 * diameter * (row % 2 - 0.5)
    places = np.column_stack([(column + 0.5) * length / columns + 0.4 * shaken, width * rng.uniform(0, 1, count),
                              (row + 0.6) * 1.05 * diameter])
    top, reach = places[:, 2].max() + diameter, 12 * max(1.0, aspect) * length
    rows = "".join(f"{n + 1} 1 {d:.10g} 2650 {x:.10g} {y:.10g} {z:.10g}\n"
                   for n, (d, (x, y, z)) in enumerate(zip(sizes, places)))
    (place / "loose.data").write_text(
        f"column\n\n{count} atoms\n1 atom types\n\n{-diameter} {reach} xlo xhi\n0 {width:.10g} ylo yhi\n"
        f"{-diameter} {2 * top} zlo zhi\n\nAtoms\n\n{rows}")
    height = aspect * length
    kn = 2650 * 9.81 * height * diameter * stiffness
    mass = 2650 * np.pi / 6 * (0.8 * diameter)**3
    dt, fall = step * np.sqrt(mass / kn), np.sqrt(2 * max(top, height) / 9.81)
    text = SCRIPT.format(
        skin=0.3 * diameter, laws="tangential coulomb" + (" rolling_friction jiang" if rolling else ""),
        kn=f"{kn:.10g}", ks=f"{0.8 * kn:.10g}", mu=mu, more=rolling, length=length, dt=f"{dt:.6g}",
        settle=int(2 * fall / dt), rest=int(fall / dt), drag=mass / (0.02 * fall), flow=int(4.5 * fall / dt))
    (place / "in.column").write_text(text)
    done = subprocess.run([PROGRAM, "--script", "in.column", "-log", "none"], cwd=place,
                          capture_output=True, text=True, check=False, timeout=1800)
    if done.returncode:
        raise RuntimeError(done.stdout[-1500:])
    before, after = _snapshot(place / "start.dump"), _snapshot(place / "end.dump")
    settled = float(np.quantile(before[:, 2] + before[:, 3], 0.98))
    front = _front(after, diameter)
    return Outcome((front - length) / length, settled / length, _slope(after, front, diameter),
                   time.monotonic() - start, count)


def _snapshot(dump: Path) -> np.ndarray:
    rows = dump.read_text().rsplit("ITEM: ATOMS", 1)[1].split("\n", 1)[1].split()
    return np.array(rows, dtype=float).reshape(-1, 4)


def _front(spheres: np.ndarray, diameter: float) -> float:
    """Where the deposit ends: 98.5 % of the mass lies at smaller x (stray grains roll on alone)."""
    order = np.argsort(spheres[:, 1])
    mass = np.cumsum(spheres[order, 3]**3)
    return float(spheres[order, 1][np.searchsorted(mass, 0.985 * mass[-1])] + diameter / 2)


def _slope(spheres: np.ndarray, front: float, diameter: float) -> float:
    """Slope of the surface between a fifth and four fifths of the deposit's length [degrees]."""
    edges = np.arange(0.2 * front, 0.8 * front, 2 * diameter)
    middle, top = [], []
    for low in edges:
        inside = (spheres[:, 1] >= low) & (spheres[:, 1] < low + 2 * diameter)
        if inside.any():
            middle.append(low + diameter)
            top.append((spheres[inside, 2] + spheres[inside, 3]).max())
    return float(np.degrees(np.arctan(-np.polyfit(middle, top, 1)[0]))) if len(top) > 2 else 0.0


def lajeunesse(aspect: float) -> float:
    """Run-out over L0 in a channel: 1.8 a below a = 3, 1.9 a^(2/3) above (Lajeunesse, Monnier & Homsy
    2005, Phys. Fluids 17, 103302, glass beads)."""
    return 1.8 * aspect if aspect < 3 else 1.9 * aspect ** (2 / 3)


def lube(aspect: float) -> float:
    """The same after Lube, Huppert, Sparks & Freundt 2005 (Phys. Rev. E 72, 041301): 1.2 a below
    a = 1.8, 1.9 a^(2/3) above 2.8."""
    return 1.2 * aspect if aspect < 1.8 else 1.9 * aspect ** (2 / 3)
