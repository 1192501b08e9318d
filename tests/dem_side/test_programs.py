"""slidewave_dem as a user starts it: dry runs against stock liggghts, and every way to go wrong."""

import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

PROGRAM = os.environ["SLIDEWAVE_DEM"]
FAKE_FLUID = os.environ["SLIDEWAVE_FAKE_FLUID"]
MPIRUN = os.environ["SLIDEWAVE_MPIRUN"].split(";")

CASE = """
[case]
name = "pile"
end_time = 0.3
[coupling]
window = 0.02
[physics]
gravity = [0, 0, -9.81]
[fluid]
engine = "none"
[dem]
engine = "liggghts"
script = "dem/in.setup"
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

# dem_dt 5e-4 fills the window of 0.02 s exactly: the stock run takes the same steps.
SETUP = """
variable friction index 0.5
units si
atom_style granular
atom_modify map array
boundary f p f
newton off
communicate single vel yes
region box block 0 10 0 3.8 0 10 units box
create_box 1 box
neighbor 0.1 bin
neigh_modify delay 0
fix kn all property/global kn peratomtypepair 1 1e7
fix kt all property/global kt peratomtypepair 1 8e6
fix gn all property/global gamman peratomtypepair 1 0
fix gt all property/global gammat peratomtypepair 1 0
fix mu all property/global coefficientFriction peratomtypepair 1 ${friction}
pair_style gran model hooke/stiffness tangential history
pair_coeff * *
lattice sc 0.95
region fill block 0.6 9.4 0 3.7 0.6 5 units box
create_atoms 1 region fill
set group all diameter 0.9 density 2650
velocity all ramp vx -1 2 z 0 5 units box
velocity all ramp vz -1 1 x 0 10 units box
fix integrate all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix floor all wall/gran model hooke/stiffness tangential history primitive type 1 zplane 0
fix left all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 0
fix right all wall/gran model hooke/stiffness tangential history primitive type 1 xplane 10
thermo 100
dump states all custom 150 states.txt id x y z vx vy vz omegax omegay omegaz
dump_modify states sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g"
"""


def mpirun(ranks, *command):
    line = [*MPIRUN, "-np", str(ranks), *map(str, command)]
    return subprocess.run(line, capture_output=True, text=True, timeout=60)


class Folder(unittest.TestCase):
    """A fresh run directory in self.dir."""

    def setUp(self):
        self.dir = Path(tempfile.mkdtemp(prefix="slidewave_dem_"))
        self.addCleanup(shutil.rmtree, self.dir)
        (self.dir / "dem").mkdir()
        self.write(CASE, SETUP)

    def write(self, case, setup):
        (self.dir / "case.toml").write_text(case)
        (self.dir / "dem" / "in.setup").write_text(setup)
        (self.dir / "dem" / "parameters").write_text("variable friction index 0.3\n")


class DryRun(Folder):
    def stock_states(self, ranks):
        folder = self.dir / "stock"
        folder.mkdir()
        script = "variable friction index 0.3\n" + SETUP + "timestep 5e-4\nrun 600\n"
        (folder / "in.stock").write_text(script)
        line = [*MPIRUN, "-np", str(ranks), "-wdir", str(folder), "liggghts", "-in", "in.stock"]
        done = subprocess.run(line, capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        return (folder / "states.txt").read_text()

    def test_trajectories_are_those_of_stock_liggghts(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                shutil.rmtree(self.dir / "stock", ignore_errors=True)
                done = mpirun(ranks, PROGRAM, self.dir)
                self.assertEqual(done.returncode, 0, done.stderr)
                ours = (self.dir / "dem" / "states.txt").read_text()
                stock = self.stock_states(ranks)
                self.assertGreater(stock.count("TIMESTEP"), 4)
                self.assertEqual(ours, stock)

    def test_outputs(self):
        done = mpirun(1, PROGRAM, os.path.relpath(self.dir))
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = (self.dir / "history.csv").read_text().splitlines()
        header = rows[0].split(",")
        for name in ("slide_speed_m_s", "slide_front_x_m", "kinetic_energy_J", "max_overlap",
                     "particles", "first_x_m", "first_vz_m_s"):
            self.assertIn(name, header)
        self.assertEqual(len(rows), 1 + 1 + 15)
        last = dict(zip(header, rows[-1].split(",")))
        self.assertGreater(float(last["slide_speed_m_s"]), 0.1)
        self.assertGreater(float(last["max_overlap"]), 0)
        written = sorted(p.name for p in (self.dir / "dem").glob("particles*"))
        self.assertEqual(written, ["particles.vtk.series", "particles_0.vtk", "particles_10.vtk",
                                   "particles_15.vtk", "particles_5.vtk"])
        self.assertIn("Loop time", (self.dir / "log.dem").read_text())
        self.assertTrue((self.dir / "summary.json").exists())


class Overlap(Folder):
    """Watched whether or not it is a column of history.csv."""

    def run_soft(self, kn, limit=None, observed=True):
        case = CASE.replace("end_time = 0.3", "end_time = 0.8")
        case = case if observed else case[:case.index("[observe.slide]")]
        case = case if limit is None else case.replace("[dem]", f"[dem]\noverlap_limit = {limit}")
        self.write(case, SETUP.replace("peratomtypepair 1 1e7", f"peratomtypepair 1 {kn}"))
        return mpirun(2, PROGRAM, self.dir)

    def test_warned_then_refused(self):
        self.assertNotIn("overlap", self.run_soft("1e7").stdout)
        for observed in (True, False):
            with self.subTest(observed=observed):
                done = self.run_soft("1e6", observed=observed)
                self.assertEqual((done.returncode, done.stdout.count("warning: particles overlap")), (0, 1), done.stderr)
                done = self.run_soft("1e6", 0.12, observed)
                self.assertEqual(done.returncode, 1, done.stderr)
                for word in ("dem.overlap_limit = 0.12", "parameters.kn", "% of the smaller diameter"):
                    self.assertIn(word, done.stderr)
        self.assertIn("dem.overlap_limit = 0.3", self.run_soft("4e5").stderr)


OWN_LAW = SETUP.replace("pair_style gran model hooke/stiffness tangential history",
                        "pair_style gran model linear tangential coulomb kn 1e7 ks 8e6 mu ${friction}")


class OwnLaw(Folder):
    def test_energy_is_audited_and_the_kernel_named(self):
        for wanted in (True, False):
            case = CASE if wanted else CASE.replace("[dem]", "[dem]\nenergy_audit = false")
            self.write(case, re.sub("(fix (?:floor|left|right) all wall/gran) .* primitive (.*)",
                                    r"\1 model linear primitive \2 kn 1e7", OWN_LAW))
            done = mpirun(1, PROGRAM, self.dir)
            self.assertEqual(done.returncode, 0, done.stderr)
            rows = (self.dir / "history.csv").read_text().splitlines()
            header = rows[0].split(",")
            self.assertEqual("energy_drift" in header, wanted)
            active = json.loads((self.dir / "summary.json").read_text())["active"]
            self.assertIn("linear + coulomb, 3 numbers of history a contact", json.dumps(active))
            self.assertNotIn("critical step", done.stdout)
            if wanted:
                last = dict(zip(header, rows[-1].split(",")))
                self.assertLess(abs(float(last["energy_drift"])), 0.01)
                self.assertGreater(float(last["heat_friction_J"]), 1)
                self.assertNotIn("work_fluid_J", header)


    def test_step_is_watched(self):
        """Over the critical step by hand: 2/sqrt(5 (10/3) ks/m), above 3/4 with a warning."""
        mass = 2650 * math.pi / 6 * 0.9**3
        for dt, warned in (("5e-4", 0), ("5e-3", 1)):
            self.write(CASE.replace("dem_dt = 5e-4", f"dem_dt = {dt}"), OWN_LAW)
            done = mpirun(2, PROGRAM, self.dir)
            self.assertEqual(done.stdout.count("of the critical step"), warned, done.stdout)
            found = json.loads((self.dir / "summary.json").read_text())["extremes"]["dem_step_fraction"]
            self.assertAlmostEqual(found, float(dt) / (2 / math.sqrt(5 * 10 / 3 * 8e6 / mass)), places=6)

    def test_two_ranks_equal_one(self):
        """Places and speeds of a collapsing pile with every feature of the law, relative to D and 1 m/s."""
        law = "model linear tangential coulomb rolling_friction jiang"
        constants = "kn 1e7 damping 0.1 ks 8e6 mu 0.3 shape 0.2 crushing 2 twist on"
        own = re.sub("pair_style .*", f"pair_style gran {law} {constants}", SETUP)
        self.write(CASE, re.sub("(fix (?:floor|left|right) all wall/gran) .* primitive (.*)",
                                rf"\1 {law} primitive \2 {constants}", own))
        ends = []
        for ranks in (1, 2):
            done = mpirun(ranks, PROGRAM, self.dir)
            self.assertEqual(done.returncode, 0, done.stderr)
            last = (self.dir / "dem" / "states.txt").read_text().rsplit("ITEM: ATOMS", 1)[1]
            ends.append([float(word) for line in last.splitlines()[1:] for word in line.split()[1:7]])
        self.assertGreater(len(ends[0]), 600)
        self.assertLess(max(abs(a - b) for a, b in zip(*ends)), 1e-10 * 0.9)


class PlainScript(Folder):
    def run_script(self, script, *extra):
        file = self.dir / "plain"
        file.write_text(script)
        return subprocess.run([PROGRAM, "--script", "plain", *extra], cwd=self.dir,
                              capture_output=True, text=True, timeout=60)

    def test_runs_with_variables_and_own_styles(self):
        script = SETUP + "fix fluid all slidewave drag 5 fluid_velocity 0 0 0\nprint 'mu ${friction}'\ntimestep 5e-4\nrun 10\n"
        done = self.run_script(script, "-var", "friction", "0.7")
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        self.assertIn("mu 0.7", done.stdout)

    def test_error_gives_a_status(self):
        done = self.run_script("units si\nnonsense here\n")
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("Unknown command", done.stdout)

    def test_missing_script_and_usage(self):
        self.assertEqual(subprocess.run([PROGRAM, "--script", "none"], cwd=self.dir,
                                        capture_output=True, check=False).returncode, 2)
        self.assertEqual(subprocess.run([PROGRAM], capture_output=True, check=False).returncode, 2)


def coupled(directory, fluid_ranks, dem_ranks):
    line = [*MPIRUN, "-np", str(fluid_ranks), FAKE_FLUID, str(directory), ":", "-np", str(dem_ranks),
            PROGRAM, str(directory)]
    return subprocess.run(line, capture_output=True, text=True, timeout=60)


COUPLED_CASE = """
[case]
name = "row"
end_time = 0.4
[coupling]
window = 0.01
smoothing_length = 0.5
[physics]
gravity = [0, 0, -9.81]
[fluid]
engine = "fake"
[dem]
engine = "liggghts"
script = "dem/in.setup"
[parameters]
dem_dt = 4e-4
cells = 8
length = 8.0
fluid_density = 1000.0
viscosity = 0.2
fluid_velocity = 1.5
[observe.first]
type = "particle"
id = 1
"""

# A row of free spheres that the fluid carries through the periodic face, and a held one.
COUPLED_SETUP = """
units si
atom_style granular
atom_modify map array sort 0 0
boundary p f f
newton off
communicate single vel yes
region box block 0 8 0 1 0 1 units box
create_box 1 box
neighbor 0.05 bin
neigh_modify delay 0
lattice sc 0.5
region fill block 0.1 7.9 0.3 0.7 0.3 0.7 units box
create_atoms 1 region fill
set group all diameter 0.05 density 1100
group held id 3
fix integrate all nve/sphere
fix weight all gravity 9.81 vector 0 0 -1
fix hold held freeze
"""


class Coupled(Folder):
    def setUp(self):
        super().setUp()
        self.write(COUPLED_CASE, COUPLED_SETUP)

    def test_momentum_is_exchanged_to_round_off(self):
        rows = []
        for ranks in ((1, 1), (2, 1), (1, 2)):
            with self.subTest(ranks=ranks):
                done = coupled(self.dir, *ranks)
                self.assertEqual(done.returncode, 0, done.stderr)
                summary = json.loads((self.dir / "summary.json").read_text())
                self.assertGreater(summary["particles"], 10)
                self.assertLess(summary["budgets"]["momentum_defect"], 1e-10)
                table = (self.dir / "history.csv").read_text().splitlines()
                names = table[0].split(",")
                last = dict(zip(names, table[-1].split(",")))
                rows.append([float(last[n]) for n in ("first_x_m", "first_z_m", "first_vx_m_s")])
        self.assertGreater(rows[0][2], 0.5)  # carried by the fluid
        for row in rows[1:]:
            for one, other in zip(rows[0], row):
                self.assertAlmostEqual(one, other, delta=1e-9 * abs(one))

    def test_work_of_the_fluid_is_audited(self):
        free = COUPLED_SETUP.replace("fix hold held freeze", "").replace(
            "lattice sc", "pair_style gran model linear kn 1e5\npair_coeff * *\nlattice sc")
        self.write(COUPLED_CASE, free)
        done = coupled(self.dir, 1, 1)
        self.assertEqual(done.returncode, 0, done.stderr)
        table = (self.dir / "history.csv").read_text().splitlines()
        last = dict(zip(table[0].split(","), table[-1].split(",")))
        self.assertGreater(float(last["work_fluid_J"]), float(last["energy_translation_J"]) / 2)
        self.assertLess(abs(float(last["energy_drift"])), 1e-3)

    def test_errors_end_both_programs(self):
        for line, reason in (("nonsense here\n", "Unknown command"),
                             ("velocity all set 0 0 -900 units box\n", "Lost atoms"),
                             ("dump d all custom/vtk 10 x*.vtk id x y z\n", "VTK dump")):
            with self.subTest(line=line):
                self.write(COUPLED_CASE.replace("window = 0.01", 'window = 0.01\noutside = "error"'),
                           COUPLED_SETUP + line)
                begin = time.time()
                done = coupled(self.dir, 1, 2)
                self.assertLess(time.time() - begin, 10)
                self.assertNotEqual(done.returncode, 0)

    def test_sides_that_disagree(self):
        self.write(COUPLED_CASE, COUPLED_SETUP.replace("9.81 vector", "9.8 vector"))
        done = coupled(self.dir, 1, 1)
        self.assertEqual(done.returncode, 2)
        self.assertIn("gravity", done.stderr)

    def test_partner_missing(self):
        begin = time.time()
        done = mpirun(1, PROGRAM, self.dir)
        self.assertLess(time.time() - begin, 20)
        self.assertEqual(done.returncode, 2)
        self.assertIn("fluid", done.stderr)


class Failures(Folder):
    """Each ends within seconds, with a status and the reason on the terminal."""

    def fails(self, *words, ranks=1, status=None):
        begin = time.time()
        done = mpirun(ranks, PROGRAM, self.dir)
        self.assertLess(time.time() - begin, 10)
        if status is None:
            self.assertNotEqual(done.returncode, 0)
        else:
            self.assertEqual(done.returncode, status, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertTrue((self.dir / "failure.txt").exists())

    def test_unknown_command(self):
        self.write(CASE, SETUP + "nonsense here\n")
        for ranks in (1, 2):
            self.fails("ERROR: Unknown command: nonsense", "nonsense here", ranks=ranks)

    def test_error_on_one_rank(self):
        self.write(CASE, SETUP + "fix more all gravity 9.81 vector 0 0 0\nrun 0\n")
        self.fails("Gravity direction vector = 0", ranks=2)

    def test_run_in_script(self):
        self.write(CASE, SETUP + "run 10\n")
        self.fails("says 'run'", "set the scene up", status=2)

    def test_run_0_is_fine(self):
        self.write(CASE, SETUP + "run 0\n")
        self.assertEqual(mpirun(1, PROGRAM, self.dir).returncode, 0)

    def test_clear(self):
        self.write(CASE, "clear\n" + SETUP)
        self.fails("clear", "in.setup", status=2)
        self.write(CASE, "variable c string clear\n${c}\n" + SETUP)
        self.fails("clear", status=2)

    def test_vtk_dump(self):
        dump = "dump vtk all custom/vtk 100 x*.vtk id x y z\n"
        self.write(CASE, SETUP + dump)
        self.fails("custom/vtk", "in.setup", status=2)
        self.write(CASE, SETUP + "variable style string custom/vtk\n" + dump.replace("custom/vtk", "${style}"))
        self.fails("VTK dump", status=2)

    def test_quit(self):
        self.write(CASE, SETUP + "quit\n")
        self.fails("ended itself")

    def test_missing_script_and_box(self):
        (self.dir / "dem" / "in.setup").unlink()
        self.fails("dem.script", status=2)
        self.write(CASE, "units si\n")
        self.fails("box", status=2)

    def test_mesh_wider_than_a_period(self):
        corners = "0 {0} 0\nvertex 10 {0} 0\nvertex 10 {1} 0", "0 {0} 0\nvertex 10 {1} 0\nvertex 0 {1} 0"
        facets = "".join(f"facet normal 0 0 1\nouter loop\nvertex {c}\nendloop\nendfacet\n" for c in corners)
        self.write(CASE, SETUP.replace("primitive type 1 zplane 0", "mesh n_meshes 1 meshes ground")
                   .replace("fix floor", "fix ground all mesh/surface file ground.stl type 1\nfix floor"))
        stl = self.dir / "dem/ground.stl"
        for ranks in (1, 2):
            stl.write_text(f"solid g\n{facets.format(-1.9, 5.7)}endsolid g\n")
            self.fails("in.setup", "fix ground", "7.6", "along y", "3.8", "count twice", ranks=ranks, status=2)
            stl.write_text(f"solid g\n{facets.format(0, 3.8)}endsolid g\n")
            self.assertEqual(mpirun(ranks, PROGRAM, self.dir).returncode, 0)

    def test_lost_particles(self):
        self.write(CASE, SETUP.replace("fix left", "#") + "velocity all set -30 0 0 units box\n")
        self.fails("Lost atoms")

    def test_lost_particles_are_let_go_on_request(self):
        outside = CASE.replace("window = 0.02", 'window = 0.02\noutside = "ignore"')
        self.write(outside, SETUP.replace("fix left", "#") + "velocity all set -30 0 0 units box\n")
        self.assertEqual(mpirun(1, PROGRAM, self.dir).returncode, 0)

    def test_blow_up(self):
        self.write(CASE, SETUP + "velocity all set 1e200 0 0 units box\n")
        self.fails()

    def test_unknown_particle(self):
        self.write(CASE.replace("id = 1", "id = 100000"), SETUP)
        self.fails("observe.first.id", "100000", status=2)

    def test_bad_contact_constants(self):
        coulomb = "model linear tangential coulomb"
        iwashita_oda, jiang = (f"{coulomb} rolling_friction {name} kn 1e6 ks 1e6 mu 0.5"
                               for name in ("iwashita_oda", "jiang"))
        for law, words in (
            ("model linear kn -5", "linear: kn is -5"),
            ("model linear", "linear: kn is missing"),
            ("model linear kn", "kn has no value"),
            ("model linear kn 1e6 damping 1.5", "damping is 1.5"),
            (coulomb + " kn 1e6 mu 0.5", "coulomb: ks is missing"),
            (coulomb + " kn 1e6 ks 0 mu 0.5", "ks is 0"),
            (coulomb + " kn 1e6 ks 1e6", "mu is missing"),
            (coulomb + " kn 1e6 ks 1e6 mu -0.1", "mu is -0.1"),
            (coulomb + " kn 1e6 ks 1e6 mu O.5", "mu is 'O.5', give a number"),
            (coulomb + " kn 1e6 ks 1e6 mu 0.5 mu 0.6", "mu is given twice"),
            (iwashita_oda + " eta 0.1", "kr is missing"),
            (iwashita_oda + " kr -1 eta 0.1", "kr is -1"),
            (iwashita_oda + " kr 10", "eta is missing"),
            (iwashita_oda + " kr 10 eta -0.1", "eta is -0.1"),
            (jiang + " crushing 2", "shape is missing"),
            (jiang + " shape 1", "crushing is missing"),
            (jiang + " shape 1 crushing -2", "crushing is -2"),
            (coulomb + " kn 1e6 ks 1e6 mu 0.5 kr 10", "Unknown argument"),
        ):
            with self.subTest(law=law):
                own = SETUP.replace("model hooke/stiffness tangential history\npair_coeff",
                                    law + "\npair_coeff")
                (self.dir / "plain").write_text(own + "timestep 1e-5\nrun 0\n")
                done = subprocess.run([PROGRAM, "--script", "plain"], cwd=self.dir, timeout=60,
                                      capture_output=True, text=True, check=False)
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(words, done.stdout)
        own = SETUP.replace("model hooke/stiffness tangential history\npair_coeff", "model linear kn 1e6\npair_coeff")
        (self.dir / "plain").write_text(own + "fix w all wall/gran model linear primitive type 1 zplane 0 kn x\n")
        done = subprocess.run([PROGRAM, "--script", "plain"], cwd=self.dir, timeout=60, capture_output=True,
                              text=True, check=False)
        self.assertIn("kn is 'x', give a number", done.stdout)
        self.write(CASE, SETUP.replace("model hooke/stiffness tangential history\npair_coeff",
                                       "model linear kn -5\npair_coeff"))
        self.fails("contact model linear: kn is -5")


if __name__ == "__main__":
    sys.exit(unittest.main())
