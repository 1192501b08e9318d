"""The scenes of the stability map (docs/stability.md): what PHYSICS demands of stiff and extreme cases, from well
inside the limits of the pre-flight check to well outside."""

from __future__ import annotations

from tests.cases.stability.columns import ROCK, held, lone, pile, settling, suspension
from tests.cases.stability.scene import Scene
from tests.cases.stability.surfaces import bounce, dam, free_fall, pool, sloshing, stays
from tests.cases.verification import spheres

MILD = {"coupling.regime": "mild"}
HARD = {"parameters.contact_stiffness": 4.0, "parameters.dem_dt": 2.5e-5}  # no impact's overlap counts
FROZEN = {"parameters.contact_stiffness": 5.0, "parameters.dem_dt": 1e-4}  # nothing moves: contacts do nothing
BOULDER = ROCK * spheres.volume(5.0)  # kg


def all_scenes() -> list[Scene]:
    """Every scene, in the order of the tables."""
    return [*_drag(), *_density(), *_packing(), *_waves(), *_contacts(), *_sizes(), *_places(), *_steps()]


def _drag() -> list[Scene]:
    found = [suspension("viscosity", f"{mu:g} Pa s", viscosity=mu, quick=mu == 10)
             for mu in (1e-6, 1e-4, 1e-2, 1, 10, 100)]
    found += [suspension("viscosity", "1000 Pa s, window 0.1 ms", viscosity=1e3, window=1e-4),
              suspension("viscosity", "1000 Pa s, window 1 ms", viscosity=1e3),
              suspension("viscosity", "1000 Pa s, window 0.1 s", viscosity=1e3, window=0.1, more=HARD)]
    found += [settling("drag, K W/m", f"settling, {x:g}", x=x) for x in (0.05, 1, 100, 1e4)]
    found += [settling("drag, K W/m", f"settling, {x:g}", x=x) for x in (1e5, 1e7, 1e10)]
    found += [suspension("drag, K W/m", f"suspension, {x:g}", x=x) for x in (1e5, 1e9, 1e10, 1e12)]
    found += [held("drag, K W/m", f"held bed, soft contacts, {x:g}", x=x, softness=1, windows=n)
              for x, n in ((1e4, 60), (1e5, 40), (5e5, 20), (1e7, 8))]
    found += [held("drag, K W/m", f"frozen bed, {x:g}", x=x, frozen=True, windows=20, more=FROZEN) for x in (1e7, 6e8)]
    found += [settling("drag, K W/m", f"settling, mild, {x:g}", x=x, phi=phi, more=MILD, quick=x == 30)
              for x, phi in ((0.1, 0.5), (0.25, 0.3), (1, 0.5), (3, 0.5), (30, 0.3), (1000, 0.3))]
    found += [settling("drag, K W/m", f"settling, mild, fraction {phi:g}, {x:g}", x=x, phi=phi, more=MILD, lattice="fcc")
              for phi, x in ((0.64, 0.3), (0.64, 0.5), (0.7, 0.15), (0.7, 0.3), (0.74, 0.1), (0.74, 0.2))]
    found += [suspension("drag, K W/m", f"suspension, mild, {x:g}", x=x, more=MILD) for x in (0.2, 1, 10, 100)]
    found += [held("drag, K W/m", f"held bed, {x:g}", x=x, ratio=20, windows=n) for x, n in ((0.1, 300), (10, 30), (1e3, 30))]
    found += [held("drag, K W/m", f"held bed, mild, {'soft' if soft == 1 else 'rigid'} contacts, {x:g}", x=x, more=MILD, windows=60,
                   softness=soft, quick=(x, soft) == (2, 1))
              for x, soft in ((0.5, 1), (2, 1), (20, 1), (100, 1), (20, 0.01))]
    return found


def _density() -> list[Scene]:
    found = [settling("density ratio", f"{r:g}, settling, K W/m {x:g}", ratio=r, x=x, phi=0.5, least=300, noise=0.004)
             for r in (0.1, 0.5, 0.9, 1, 1.5, 2.65, 20, 2000) for x in (0.1, 10)]
    found += [suspension("density ratio", f"{r:g}, suspension", ratio=r, x=1)
              for r in (0.1, 0.5, 1, 2.65, 20, 2000)]
    found += [held("density ratio", f"{r:g}, held bed, K W/m {x:g}", ratio=r, x=x)
              for r in (0.1, 0.5, 1, 1.5, 20, 2000) for x in (1, 100)]
    return found


def _packing() -> list[Scene]:
    found = [held("packing", f"{phi:g}, frozen", x=10, phi=phi, lattice="fcc", frozen=True, quick=phi == 0.74)
             for phi in (0.64, 0.7, 0.74)]
    found += [held("packing", f"0.74, every other layer held, K W/m {x:g}", x=x, lattice="fcc") for x in (1, 100)]
    found += [settling("packing", f"{phi:g}, free, K W/m {x:g}", phi=phi, x=x, lattice="fcc")
              for phi in (0.64, 0.7, 0.74) for x in (0.05, 0.1, 10)]
    found += [pile("packing", "0.74, a pile of boulders", kn=1e9, window=0.01, windows=60, lattice="fcc"),
              pile("packing", "0.74, a pile, stiff drag", kn=1e9, window=0.01, windows=60, lattice="fcc", viscosity=3e4)]
    return found


def _waves() -> list[Scene]:
    """Undamped piles of boulders: what the lagged added mass feeds, the more the faster the contact wave."""
    found = []
    for run, lattice in ((0.5, "sc"), (1, "sc"), (1.8, "sc"), (6, "sc"), (0.5, "fcc"), (1, "fcc"), (1.8, "fcc"), (3, "fcc"), (10, "fcc")):
        spacing = 1.0 if lattice == "sc" else 2**0.5  # of the lattice, over the diameter
        kn = (run * 2.4 * spacing / 0.02) ** 2 * BOULDER
        found.append(pile("contact waves, c W/L", f"{run:g}, fraction {'0.52' if lattice == 'sc' else '0.74'}", kn=kn, window=0.02,
                          windows=400, layers=12, damping=0, lattice=lattice, more={"parameters.noise": 5e-7}))
    found += [pile("contact waves, c W/L", "10, fraction 0.52, in air", kn=(24 / 0.02) ** 2 * BOULDER, window=0.02, windows=200,
                   layers=12, damping=0, fluid=1.2, viscosity=1.8e-5, more={"parameters.noise": 5e-7})]
    return found


def _contacts() -> list[Scene]:
    found = [pile("stiffness kn [N/m]", f"{kn:g}", kn=kn, window=w, windows=n, quick=kn == 1e7)
             for kn, w, n in ((1e3, 0.02, 100), (1e5, 0.02, 100), (1e6, 0.02, 100), (1e7, 0.02, 100), (1e8, 0.02, 100),
                              (1e9, 0.02, 100), (1e10, 0.005, 100), (1e12, 5e-4, 100))]
    dry = {"fluid.engine": "none", "coupling.regime": "mild", "parameters.noise": 1e-3, "parameters.friction": 50}
    found += [pile("particle step over critical", f"{share:g}, sticking contacts", kn=1e9, window=0.2, windows=20, layers=6,
                   step=0.3139 * share, damping=0, lattice="fcc", quick=share == 1.2, more=dry)
              for share in (0.3, 0.7, 0.95, 1.2, 1.6, 3)]
    found += [pile("particle step over critical", "1.2, friction 0.5", kn=1e9, window=0.2, windows=20, layers=6,
                   step=0.3139 * 1.2, damping=0, lattice="fcc", more=dry | {"parameters.friction": 0.5})]
    found += [bounce("impact, overlap [D]", f"{overlap:g}", overlap=overlap) for overlap in (0.02, 0.15, 0.3, 0.8)]
    return found


def _sizes() -> list[Scene]:
    found = [lone("cell over diameter", f"{cell:g}", cell=cell, cells=n, kernel=1.5, x=0.1, windows=40, closed_form=False,
                  finer={"parameters.cells_across": m, "parameters.cells_up": m}, column="one_vz_m_s")
             for cell, n, m in ((0.5, 6, 3), (0.25, 12, 6), (0.15, 16, 5), (0.1, 24, 8))]
    found += [lone("cell over diameter", f"{cell:g}", cell=cell, cells=n, kernel=kernel)
              for cell, n, kernel in ((1, 10, 3), (5, 8, 15), (40, 4, 120))]
    found += [lone("kernel over diameter", f"{kernel:g}", kernel=kernel, more={"parameters.contact_stiffness": 0.1})
              for kernel in (3, 1.5, 0.9, 0.6, 0.45, 0.3)]
    found += [lone("sub-steps in a window", f"{n}", more={"parameters.dem_dt": 1e-3 / n, "parameters.contact_stiffness": 0.1})
              for n in (1, 10, 100, 1000)]
    return found


def _places() -> list[Scene]:
    corner = {"parameters.cells_across": 4, "parameters.cells_up": 8, "parameters.filled": 2}
    found = [lone("place", "on a face between processors", offset=0.5, ranks=(2, 1), finer={}, column="one_z_m"),
             suspension("place", "crossing processors", x=1, ranks=(2, 2), more=corner),
             pool("place", "in air", windows=20, first=34, error=free_fall, quick=True),
             pool("place", "held at the surface", windows=100, first=18, more={"parameters.held": 1}, error=stays),
             pool("place", "floating, ratio 0.5", windows=400, first=16, ratio=0.5),
             pool("place", "floating, ratio 0.1", windows=400, first=16, ratio=0.1),
             pool("place", "leaving through the top", windows=60, first=50, speed=1, allowed=2, lost=True,
                  more={"coupling.outside": "ignore"}),
             pool("place", "no particles", windows=20, more={"dem.engine": "none"})]
    found += [pool("into water", f"{v:g} m/s, boulders, window {w:g} s", size=5e3, speed=-v, allowed=1.2 * v, window=w, windows=n,
                   first=22, finer={"coupling.window": w / 8, "parameters.dem_dt": w / 8 / k, "parameters.fluid_dt": w / 8},
                   more={"parameters.water_viscosity": 1e-3})
              for v, w, n, k in ((20, 0.02, 100, 40), (100, 0.005, 100, 20), (100, 0.02, 50, 80), (100, 0.12, 20, 400))]
    return found


def _steps() -> list[Scene]:
    found = [sloshing("fluid step", f"Courant number {0.1 * dt * 36:.2g}", fluid_dt=dt) for dt in (0.01, 0.05, 0.3, 0.6)]
    found += [dam("fluid step", f"dam break, interface Courant number {112 * dt:.2g}", fluid_dt=dt) for dt in (0.0025, 0.0125, 0.025)]
    return found


