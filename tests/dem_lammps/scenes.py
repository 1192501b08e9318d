"""Dry scenes that LIGGGHTS and LAMMPS can both set up, each in its own language, from one description.

The contact law is the linear spring and dashpot with Coulomb's slider that both call hooke: kn, kt [N/m],
damping per mass [1/s]. LIGGGHTS takes the lever arm of friction at the contact, LAMMPS at the radius."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np


@dataclass
class Scene:
    """Spheres (x, y, z, diameter [m]) in a box with a floor at z = 0 and a wall at x = 0."""

    spheres: np.ndarray
    box: tuple[float, float, float]
    kn: float = 1e5
    kt: float = 8e4
    damping: float = 60.0
    friction: float = 0.5
    boundary: str = "f p f"
    density: float = 2650.0
    walls: tuple[str, ...] = ("zplane", "xplane")
    gravity: float = 9.81
    slope_deg: float = 0.0  # of the floor, downwards in x
    velocities: list[str] = field(default_factory=list)  # "ID vx vy vz"

    def data(self) -> str:
        """A data file: id type diameter density x y z, the same columns in both codes."""
        rows = [f"{i} 1 {d:.9g} {self.density} {x:.12g} {y:.12g} {z:.12g}"
                for i, (x, y, z, d) in enumerate(self.spheres, start=1)]
        bounds = "\n".join(f"0 {size} {axis}lo {axis}hi" for axis, size in zip("xyz", self.box))
        return f"spheres\n\n{len(rows)} atoms\n1 atom types\n\n{bounds}\n\nAtoms\n\n" + "\n".join(rows) + "\n"

    def script(self, engine: str, own_law: bool = False) -> str:
        """The set-up script for dem.engine; it reads spheres.data. `own_law`: slidewave's linear and coulomb
        in place of LIGGGHTS' hooke (their damping is a fraction of the critical one)."""
        ours = engine == "liggghts"
        kn, kt, damp, mu = self.kn, self.kt, self.damping, self.friction
        if ours and own_law:
            law, numbers = "gran model linear tangential coulomb", f"kn {kn} damping 0.1 ks {kt} mu {mu}"
            pair = [f"pair_style {law} {numbers}", "pair_coeff * *"]
            walls = [f"fix {name} all wall/{law} primitive type 1 {name} 0 {numbers}" for name in self.walls]
        elif ours:
            law = "gran model hooke/stiffness tangential history"
            pair = [f"fix {name} all property/global {name} peratomtypepair 1 {value}" for name, value in
                    (("kn", kn), ("kt", kt), ("gamman", damp), ("gammat", damp), ("coefficientFriction", mu))]
            pair += [f"pair_style {law}", "pair_coeff * *"]
            walls = [f"fix {name} all wall/{law} primitive type 1 {name} 0" for name in self.walls]
        else:
            law = f"hooke/history {kn} {kt} {damp} {damp} {mu} 1"
            pair = [f"pair_style gran/{law}", "pair_coeff * *"]
            walls = [f"fix {name} all wall/gran {law} {name} 0 NULL" for name in self.walls]
        largest = float(self.spheres[:, 3].max())
        moves = [line for k, words in enumerate(self.velocities) for line in
                 (f"group m{k} id {words.split()[0]}",
                  f"velocity m{k} set {' '.join(words.split()[1:])} units box")]
        return "\n".join([
            "units si", f"atom_style {'granular' if ours else 'sphere'}", "atom_modify map array",
            f"boundary {self.boundary}", "newton off",
            "communicate single vel yes" if ours else "comm_modify vel yes", "read_data spheres.data",
            f"neighbor {0.2 * largest:g} bin", "neigh_modify delay 0", *pair, *walls, *moves,
            f"fix weight all gravity {self.gravity} vector {np.sin(np.radians(self.slope_deg)):.17g} 0 "
            f"{-np.cos(np.radians(self.slope_deg)):.17g}", "fix motion all nve/sphere",
            "timestep 1e-4"]) + "\n"


def column(seed: int, nx: int = 8, ny: int = 4, nz: int = 12, d: float = 0.1) -> Scene:
    """A loose column of spheres beside a wall, which collapses to a heap; period of ny spheres in y."""
    random = np.random.default_rng(seed)
    i, j, k = np.meshgrid(range(nx), range(ny), range(nz), indexing="ij")
    x, y, z = (0.55 * d + 1.06 * d * n.ravel() + 0.02 * d * random.uniform(-1, 1, n.size) for n in (i, j, k))
    size = d * random.uniform(0.9, 1.0, x.size)
    return Scene(np.stack([x, y, z, size], axis=1), (60 * d, 1.06 * d * ny, 2 * nz * d))


def slide(seed: int) -> Scene:
    """A heap let go on a rough slope of 25 degrees."""
    heap = column(seed, 12, 4, 8)
    heap.slope_deg = 25.0
    return heap


def bounces() -> Scene:
    """Laws that coincide: a sphere falling on the floor, and two that meet head on; no friction."""
    spheres = np.array([[0.3, 0.2, 0.4, 0.1], [0.6, 0.2, 0.3, 0.1], [0.9, 0.2, 0.3, 0.08]])
    return Scene(spheres, (2.0, 0.4, 1.0), friction=0.0, velocities=["2 1.5 0 2", "3 -0.5 0 2"])
