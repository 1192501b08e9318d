"""Small OpenFOAM cases for the tests: written, run and read here."""
import csv
import os
import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

ENVIRONMENT = {**os.environ, "WM_PROJECT_DIR": os.environ.get("WM_PROJECT_DIR", "/usr/share/openfoam"),
               "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
TIGHT = 1e-13


def dictionary(name, body, kind="dictionary"):
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n{body}\n"


class Case:
    """A box of cells, one block: x fastest, then y, then z. 2-D in x and z where ny = 1."""

    def __init__(self, cells, size, two_fluids=True, tolerance=TIGHT, slope=0.0, periodic=(), closed=False,
                 extra_solution="", water="nAlphaCorr 2; nAlphaSubCycles 1; cAlpha 1;", dt=1e-3, controls="", normals="corrected"):
        self.directory = pathlib.Path(tempfile.mkdtemp(prefix="foam_"))
        self.fluid = self.directory / "fluid"
        self.cells, self.size, self.slope = cells, size, slope
        self.two_fluids, self.periodic, self.closed, self.dt = two_fluids, periodic, closed, dt
        for folder in ("0", "constant", "system"):
            (self.fluid / folder).mkdir(parents=True)
        self.write("constant/transportProperties",
                   "phases (water air);\nwater { transportModel Newtonian; nu 1e-6; rho 1000; }\n"
                   "air { transportModel Newtonian; nu 1.48e-5; rho 1.2; }\nsigma 0;" if two_fluids else
                   "transportModel Newtonian; nu 1e-3; rho 1000;")
        self.write("constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);",
                   "uniformDimensionedVectorField")
        self.write("constant/turbulenceProperties", "simulationType laminar;")
        self.write("system/fvSchemes", f"""
ddtSchemes {{ default Euler; }}
gradSchemes {{ default Gauss linear; }}
divSchemes {{ default none; div(rhoPhi,U) Gauss linearUpwind grad(U); div(phi,U) Gauss linearUpwind grad(U);
  div(phi,alpha) Gauss vanLeer; div(phirb,alpha) Gauss linear;
  div(((rho*nuEff)*dev2(T(grad(U))))) Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear; }}
laplacianSchemes {{ default Gauss linear {normals}; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default {normals}; }}""")
        solver = f"{{ solver PCG; preconditioner DIC; tolerance {tolerance}; relTol 0; maxIter 5000; }}"
        self.write("system/fvSolution", f"""
solvers {{
  "alpha.water.*" {{ {water} solver smoothSolver; smoother symGaussSeidel; tolerance 1e-13; relTol 0; }}
  "pcorr.*" {solver}
  p_rgh {solver} p_rghFinal {solver} p {solver} pFinal {solver}
  "U.*" {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-13; relTol 0; }}
}}
PIMPLE {{ momentumPredictor no; nOuterCorrectors 1; nCorrectors 3; nNonOrthogonalCorrectors {2 if slope else 0};
  pRefCell 0; pRefValue 0; {extra_solution} }}
relaxationFactors {{ fields {{ }} equations {{ ".*" 1; }} }}""")
        self.controls(controls)

    def write(self, path, body, kind="dictionary"):
        (self.fluid / path).write_text(dictionary(pathlib.Path(path).name, body, kind))

    def controls(self, more="", end=1.0):
        self.write("system/controlDict", f"""
application interFoam; startFrom startTime; startTime 0; stopAt endTime; endTime {end}; deltaT {self.dt};
writeControl runTime; writeInterval {end}; writeFormat ascii; writePrecision 16; timePrecision 8;
adjustTimeStep no; maxCo 0.5; maxAlphaCo 0.5; maxDeltaT 1; {more}""")

    def mesh(self):
        lx, ly, lz = self.size
        top = lambda x, z: z + self.slope * x
        points = [(x, y, top(x, z)) for z in (0, lz) for y in (0, ly) for x in (0, lx)]
        text = " ".join("({} {} {})".format(*p) for p in points)
        faces = {"left": "(0 4 6 2)", "right": "(1 3 7 5)", "front": "(0 1 5 4)", "back": "(2 6 7 3)",
                 "bottom": "(0 2 3 1)", "top": "(4 5 7 6)"}
        kinds = {name: "wall" for name in faces}
        kinds["top"] = "wall" if self.closed else "patch"
        if self.cells[1] == 1 and "y" not in self.periodic:
            kinds["front"] = kinds["back"] = "empty"
        pairs = {"x": ("left", "right"), "y": ("front", "back"), "z": ("bottom", "top")}
        patches = ""
        self.patches = {}
        for name, face in faces.items():
            other = next((p[1 - p.index(name)] for a, p in pairs.items() if a in self.periodic and name in p), None)
            kind = f"type cyclic; neighbourPatch {other};" if other else f"type {kinds[name]};"
            self.patches[name] = "cyclic" if other else kinds[name]
            patches += f"{name} {{ {kind} faces ({face}); }}\n"
        self.write("system/blockMeshDict",
                   f"convertToMeters 1; vertices ({text}); blocks (hex (0 1 3 2 4 5 7 6) "
                   f"({self.cells[0]} {self.cells[1]} {self.cells[2]}) simpleGrading (1 1 1));\n"
                   f"edges (); boundary ({patches}); mergePatchPairs ();")
        self.tool("blockMesh")
        return self

    def field(self, name, values, dimensions, patches, default):
        """values: a number, a vector, or an array a cell; patches: text by patch name."""
        array = np.asarray(values, dtype=float)
        cells = int(np.prod(self.cells))
        vector = array.shape[-1:] == (3,)
        show = (lambda v: "({:.17g} {:.17g} {:.17g})".format(*v)) if vector else "{:.17g}".format
        if array.ndim == (1 if vector else 0):
            inside = f"uniform {show(array)}"
        else:
            assert len(array) == cells
            inside = f"nonuniform List<{'vector' if vector else 'scalar'}> {cells}\n(\n" + \
                "\n".join(show(v) for v in array) + "\n)\n"
        text = "".join(f"{p} {{ {'type ' + k + ';' if k in ('empty', 'cyclic') else patches.get(p, default)} }}\n"
                       for p, k in self.patches.items())
        self.write(f"0/{name}", f"dimensions {dimensions}; internalField {inside};\nboundaryField {{ {text} }}",
                   "volVectorField" if vector else "volScalarField")

    def fields(self, water=None, U=(0, 0, 0), wall="type slip;", patches=None):
        patches = patches or {}
        closed = self.closed or "z" in self.periodic
        velocity = {} if closed else {"top": "type pressureInletOutletVelocity; value uniform (0 0 0);"}
        self.field("U", U, "[0 1 -1 0 0 0 0]", {**velocity, **patches.get("U", {})}, wall)
        if not self.two_fluids:
            outlet = {} if closed else {"top": "type fixedValue; value uniform 0;"}
            self.field("p", 0, "[0 2 -2 0 0 0 0]", {**outlet, **patches.get("p", {})}, "type zeroGradient;")
            return self
        outlet = {} if closed else {"top": "type totalPressure; p0 uniform 0; value uniform 0;"}
        self.field("p_rgh", 0, "[1 -1 -2 0 0 0 0]", {**outlet, **patches.get("p", {})},
                   "type fixedFluxPressure; value uniform 0;")
        outlet = {} if closed else {"top": "type inletOutlet; inletValue uniform 0; value uniform 0;"}
        self.field("alpha.water", water, "[0 0 0 0 0 0 0]", {**outlet, **patches.get("alpha", {})},
                   "type zeroGradient;")
        return self

    def centres(self):
        """Cell centres of the box, in OpenFOAM's order."""
        spans = [(np.arange(n) + 0.5) * s / n for n, s in zip(self.cells, self.size)]
        z, y, x = np.meshgrid(*spans[::-1], indexing="ij")
        return np.stack([x.ravel(), y.ravel(), (z + self.slope * x).ravel()], axis=1)

    def cell_volume(self):
        return np.prod(self.size) / np.prod(self.cells)

    def tool(self, *command):
        done = subprocess.run(command, cwd=self.fluid, env=ENVIRONMENT, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(" ".join(command) + "\n" + done.stdout[-3000:] + done.stderr[-2000:])
        return done.stdout

    def case(self, end, window, smoothing=0.0, reaction="two_way", dem="test", more=""):
        (self.directory / "case.toml").write_text(
            f'[case]\nname = "test"\nend_time = {end}\n[coupling]\nwindow = {window}\n'
            f'smoothing_length = {smoothing}\nreaction = "{reaction}"\n'
            f'[fluid]\nengine = "openfoam"\n[dem]\nengine = "{dem}"\n[output]\ninterval = {end}\n{more}\n')

    def particles(self, x, volume, v=(0, 0, 0), drag=0.0, force=(0, 0, 0)):
        x = np.atleast_2d(np.asarray(x, float))
        n = len(x)
        rows = np.hstack([x, np.broadcast_to(v, (n, 3)), np.broadcast_to(np.reshape(volume, (-1, 1)), (n, 1)),
                          np.broadcast_to(np.reshape(drag, (-1, 1)), (n, 1)), np.broadcast_to(force, (n, 3))])
        np.savetxt(self.directory / "particles.csv", rows, delimiter=",", fmt="%.17g")

    def drive(self, ranks=1, fails=False):
        command = [os.environ["FOAM_DRIVE"], str(self.directory)]
        if ranks > 1:
            self.write("system/decomposeParDict",
                       f"numberOfSubdomains {ranks}; method simple; simpleCoeffs {{ n ({ranks} 1 1); delta 0.001; }}")
            self.tool("decomposePar", "-force")
            command = os.environ["MPIRUN"].split() + ["-np", str(ranks)] + command
        done = subprocess.run(command, env=ENVIRONMENT, capture_output=True, text=True)
        (self.directory / "log").write_text(done.stdout)
        if fails:
            return done
        if done.returncode:
            raise RuntimeError(done.stdout[-3000:] + done.stderr[-3000:])
        return self.table("samples.csv"), self.table("windows.csv")

    def table(self, name):
        with open(self.directory / name, encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        return {key: np.array([float(row[key]) for row in rows]) for key in (rows[0] if rows else {})}

    def read(self, time, name):
        text = (self.fluid / time / name).read_text()
        inside = text[text.index("internalField"):]
        vector = "volVectorField" in text
        if inside.split()[1] == "uniform":
            value = inside[inside.index("uniform") + 7:inside.index(";")].replace("(", "").replace(")", "")
            values = np.tile(np.array(value.split(), float), (int(np.prod(self.cells)), 1))
        else:
            body = inside[inside.index("(") + 1:]
            body = body[:body.index("\n)\n")]
            values = np.array(body.replace("(", " ").replace(")", " ").split(), float)
        return values.reshape(-1, 3) if vector else values.ravel()

    def done(self):
        shutil.rmtree(self.directory)


def column(cells, size, depth, **settings):
    """Water to `depth` in a 2-D box of `cells` (nx, nz), air above, open top."""
    case = Case((cells[0], 1, cells[1]), (size[0], size[0] / cells[0], size[1]), **settings).mesh()
    x = case.centres()
    dz = size[1] / cells[1]
    across = np.linspace(-0.5, 0.5, 65) * case.slope * size[0] / cells[0]  # cells are parallelograms
    water = np.mean([np.clip((depth - (x[:, 2] + rise - dz / 2)) / dz, 0, 1) for rise in across], axis=0)
    return case.fields(water)
