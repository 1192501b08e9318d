"""Restarts of slidewave_dem on scenes full of contacts, dry: what goes on from a checkpoint is, to the
last bit, the run that also wrote it. Packaged and own contact laws, planes and a mesh wall, 1 and 2
ranks, particles that migrate; other ranks agree in what is not chaotic."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAM = os.environ["SLIDEWAVE_DEM"]
MPIRUN = os.environ["SLIDEWAVE_MPIRUN"].split(";")

CASE = """
[case]
name = "pile"
end_time = 0.6
[coupling]
window = 0.02
[physics]
gravity = [0, 0, -9.81]
[fluid]
engine = "none"
[dem]
engine = "liggghts"
script = "dem/in.setup"
[checkpoint]
windows = 10
keep = 9
[parameters]
dem_dt = 5e-4
[output]
interval = 0.1
layers = 4
[observe.slide]
type = "slide"
[observe.first]
type = "particle"
id = 1
"""

# A heap that collapses along x while it falls on a floor; y is periodic.
SCENE = """
units si
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
region box block -1 11 0 3.8 -1 10 units box
create_box 1 box
neighbor 0.1 bin
neigh_modify delay 0
{law}
lattice sc 0.95
region fill block 0.6 6 0 3.7 0.6 5 units box
create_atoms 1 region fill
set group all diameter 0.9 density 2650
velocity all ramp vx -1 2 z 0 5 units box
velocity all ramp vz -1 1 x 0 10 units box
fix integrate all nve/sphere
fix weight all gravity 9.81 vector 0.3 0 -1
{walls}
thermo 100
dump states all custom 200 states.txt id x y z vx vy vz omegax omegay omegaz
dump_modify states sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
"""
PACKAGED = """
fix kn all property/global kn peratomtypepair 1 1e7
fix kt all property/global kt peratomtypepair 1 8e6
fix gn all property/global gamman peratomtypepair 1 20
fix gt all property/global gammat peratomtypepair 1 5
fix mu all property/global coefficientFriction peratomtypepair 1 0.4
pair_style gran model hooke/stiffness tangential history
pair_coeff * *
"""
PACKAGED_WALL = "model hooke/stiffness tangential history"
OWN = "model linear tangential coulomb rolling_friction iwashita_oda"
OWN_CONSTANTS = "kn 1e7 damping 0.05 ks 8e6 mu 0.4 kr 1e5 eta 0.1"
PLANES = "\n".join(f"fix wall{k} all wall/gran {{law}} primitive type 1 {plane} {{constants}}"
                   for k, plane in enumerate(("zplane 0", "xplane 0", "xplane 10")))
MESH = """fix floor all mesh/surface file floor.stl type 1
fix wall all wall/gran {law} mesh n_meshes 1 meshes floor {constants}
fix end all wall/gran {law} primitive type 1 xplane 10 {constants}
fix begin all wall/gran {law} primitive type 1 xplane 0 {constants}"""
SCENES = {
    "packaged law, planes": SCENE.format(law=PACKAGED, walls=PLANES.format(law=PACKAGED_WALL, constants="")),
    "packaged law, mesh": SCENE.format(law=PACKAGED, walls=MESH.format(law=PACKAGED_WALL, constants="")),
    "own law, mesh": SCENE.format(law=f"pair_style gran {OWN} {OWN_CONSTANTS}\npair_coeff * *",
                                  walls=MESH.format(law=OWN, constants=OWN_CONSTANTS)),
}


def floor_stl():
    """A floor of triangles, bent so that grains touch several at a time."""
    xs, height = [-1 + 0.75 * k for k in range(17)], lambda k: 0.1 * (k % 2)
    text = "solid floor\n"
    for k in range(16):
        for y in (0, 1.9):
            a, b = (xs[k], y, height(k)), (xs[k + 1], y, height(k + 1))
            c, d = (xs[k], y + 1.9, height(k)), (xs[k + 1], y + 1.9, height(k + 1))
            for triangle in ((a, b, d), (a, d, c)):
                corners = "".join("vertex {:g} {:g} {:g}\n".format(*p) for p in triangle)
                text += f"facet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\n"
    return text + "endsolid floor\n"


def run(directory, ranks):
    return subprocess.run([*MPIRUN, "-np", str(ranks), PROGRAM, str(directory)], capture_output=True, text=True,
                          timeout=100, check=False)


def pieces(directory, window):
    return json.loads((directory / f"checkpoints/{window:08d}/manifest.json").read_text())["pieces"]


class Restart(unittest.TestCase):
    def setUp(self):
        self.place = Path(tempfile.mkdtemp(prefix="slidewave_restart_"))
        self.addCleanup(shutil.rmtree, self.place)

    def whole(self, scene, ranks, name="whole"):
        directory = self.place / name
        (directory / "dem").mkdir(parents=True)
        (directory / "case.toml").write_text(CASE)
        (directory / "dem/in.setup").write_text(SCENES[scene])
        (directory / "dem/floor.stl").write_text(floor_stl())
        done = run(directory, ranks)
        self.assertEqual(done.returncode, 0, done.stderr)
        return directory

    def from_window_10(self, whole, ranks):
        """The same run, killed somewhere after window 10: later files are there, checkpoints not."""
        directory = self.place / "again"
        shutil.rmtree(directory, ignore_errors=True)
        shutil.copytree(whole, directory)
        for window in (20, 30):
            shutil.rmtree(directory / f"checkpoints/{window:08d}")
        done = run(directory, ranks)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        self.assertIn("going on after window 10", done.stdout)
        return directory, done.stdout

    def test_bit_for_bit(self):
        for scene in SCENES:
            for ranks in (1, 2):
                with self.subTest(scene=scene, ranks=ranks):
                    whole = self.whole(scene, ranks, f"{scene}{ranks}")
                    again, _ = self.from_window_10(whole, ranks)
                    self.assertEqual((again / "history.csv").read_text(), (whole / "history.csv").read_text())
                    for window in (20, 30):
                        self.assertEqual(pieces(again, window), pieces(whole, window))
                    self.assertEqual((again / "dem/particles.vtk.series").read_text(),
                                     (whole / "dem/particles.vtk.series").read_text())
                    self.assertEqual((again / "dem/particles_30.vtk").read_bytes(),
                                     (whole / "dem/particles_30.vtk").read_bytes())
                    frames = (again / "dem/states.txt").read_text().split("ITEM: TIMESTEP\n")[1:]
                    last = (whole / "dem/states.txt").read_text().split("ITEM: TIMESTEP\n")[-1]
                    self.assertEqual(frames[-1], last, "dumps of the script go on too")

    def test_a_checkpoint_does_not_disturb(self):
        """Without checkpoints the same motion, but for the order in which forces are added."""
        whole = self.whole("own law, mesh", 2)
        shutil.rmtree(whole / "checkpoints")
        rows = (whole / "history.csv").read_text().splitlines()
        (whole / "case.toml").write_text(CASE.replace("windows = 10", "windows = 1000"))
        self.assertEqual(run(whole, 2).returncode, 0)
        plain = (whole / "history.csv").read_text().splitlines()
        column = rows[0].split(",").index("kinetic_energy_J")
        for one, two in zip(rows[1:16], plain[1:16]):
            one, two = float(one.split(",")[column]), float(two.split(",")[column])
            self.assertAlmostEqual(one, two, delta=1e-9 * one)

    def test_other_ranks(self):
        for before, now in ((2, 1), (1, 2), (2, 3)):
            with self.subTest(before=before, now=now):
                shutil.rmtree(self.place / "whole", ignore_errors=True)
                whole = self.whole("own law, mesh", before)
                again, text = self.from_window_10(whole, now)
                self.assertIn("not bit for bit", text)
                rows = [(d / "history.csv").read_text().splitlines() for d in (whole, again)]
                names = rows[0][0].split(",")
                for row in (11, 12, 13):  # soon after the restart
                    one, two = (dict(zip(names, map(float, r[row + 1].split(",")))) for r in rows)
                    self.assertEqual(one["particles"], two["particles"])
                    self.assertEqual(two["particles_lost"], 0)
                    for name in ("kinetic_energy_J", "slide_speed_m_s", "first_x_m"):
                        self.assertAlmostEqual(one[name], two[name], delta=1e-6 * abs(one[name]))

    def test_changed_script_is_refused(self):
        whole = self.whole("packaged law, planes", 1)
        script = whole / "dem/in.setup"
        script.write_text(script.read_text() + "fix more all property/atom more scalar yes no no 0\n")
        done = run(whole, 1)
        self.assertEqual(done.returncode, 1)
        self.assertIn("the script or the models have changed", done.stderr)
        self.assertIn("more (property/atom)", done.stderr)

    def test_fix_with_state_of_its_own(self):
        whole = self.whole("packaged law, planes", 1)
        script = whole / "dem/in.setup"
        script.write_text(script.read_text() + "fix mean all ave/time 1 1 10 c_thermo_temp\n")
        shutil.rmtree(whole / "checkpoints")
        done = run(whole, 1)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("cannot save its state", done.stderr)


if __name__ == "__main__":
    sys.exit(unittest.main())
