"""Reads a set-up script of LIGGGHTS or LAMMPS far enough to know its scene before anything runs: box, periodic
sides, particles that the script or its data file names, walls, contact stiffness. What it cannot
follow (loops, insertion) it leaves unknown: None."""

from __future__ import annotations

import ast
import math
import operator
import re
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from launch import dem_lattice
from launch.errors import InputError

OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
             ast.Div: operator.truediv, ast.Pow: operator.pow, ast.USub: operator.neg,
             ast.UAdd: operator.pos}
FUNCTIONS = {"sqrt": math.sqrt, "exp": math.exp, "abs": abs, "tan": math.tan, "sin": math.sin,
             "cos": math.cos, "ceil": math.ceil, "floor": math.floor}
CREATORS = ("read_data", "read_restart", "create_atoms", "insert/pack", "insert/stream",
            "insert/rate/region", "insert/rate", "create_particles", "pour", "deposit")


@dataclass
class DemScene:
    """What a script sets up. Lengths in m, stiffness in N/m, density in kg/m3."""

    periodic: tuple[bool, bool, bool] = (False, False, False)
    box: np.ndarray | None = None  # (2, 3): lowest and highest corner
    positions: np.ndarray | None = None  # (N, 3); None: not known before the run
    diameters: np.ndarray | None = None  # (N,)
    densities: np.ndarray | None = None  # (N,)
    creates: bool = False  # whether any command makes particles
    stiffness_N_m: float | None = None
    tangential_stiffness_N_m: float | None = None
    own_law: bool = False  # model linear: tells periodic images apart, scales its constants
    gravity: bool = False
    commands: list[list[str]] = field(default_factory=list)


def evaluate(text: str, variables: dict[str, str]) -> float:
    """Value of a formula of `variable NAME equal`: arithmetic, v_NAME, a few functions.
    Raises ValueError for anything else."""

    def walk(node: ast.AST) -> float:
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return float(node.value)
        if isinstance(node, ast.Name):
            return math.pi if node.id == "PI" else float(variables[node.id.removeprefix("v_")])
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATORS:
            return OPERATORS[type(node.op)](walk(node.left), walk(node.right))
        if isinstance(node, ast.UnaryOp) and type(node.op) in OPERATORS:
            return OPERATORS[type(node.op)](walk(node.operand))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in FUNCTIONS:
            return FUNCTIONS[node.func.id](*map(walk, node.args))
        raise ValueError(text)

    try:
        return walk(ast.parse(text.replace("^", "**"), mode="eval").body)
    except (SyntaxError, KeyError, TypeError, ZeroDivisionError, OverflowError) as error:
        raise ValueError(text) from error


def substitute(line: str, variables: dict[str, str]) -> str:
    """Puts values for ${name}, $x and $(formula); an unknown one stays as it is."""

    def value(match: re.Match[str]) -> str:
        name, letter, formula = match.groups()
        if formula is not None:
            try:
                return repr(evaluate(formula, variables))
            except ValueError:
                return match.group()
        return variables.get(name or letter, match.group())

    return re.sub(r"\$\{(\w+)\}|\$(\w)|\$\(([^()]*)\)", value, line)


def read(script: Path, parameters: Path | None = None) -> DemScene:
    """The scene of a script; `parameters` is read before it (dem/parameters of a run)."""
    scene = DemScene()
    variables: dict[str, str] = {}
    regions: dict[str, np.ndarray] = {}
    diameter = density = None
    singles: list[list[float]] = []
    lattice: list[str] = []
    filled: list[np.ndarray | None] = []
    for file in filter(None, (parameters, script)):
        for words in _lines(file, variables, script.parent):
            scene.commands.append(words)
            command, rest = words[0], words[1:]
            if command == "variable" and len(rest) >= 3:
                _set_variable(variables, rest)
            elif command == "boundary" and len(rest) >= 3:
                scene.periodic = tuple(w == "p" for w in rest[:3])
            elif command == "region" and len(rest) >= 8 and rest[1] == "block" and "box" in rest[8:]:
                regions[rest[0]] = _block(rest[2:8])
            elif command == "create_box" and len(rest) >= 2:
                scene.box = regions.get(rest[1])
            elif command == "read_data":
                _read_data(script.parent / rest[0], scene)
            elif command == "create_atoms" and rest[1:2] == ["single"]:
                singles.append([_number(w) for w in rest[2:5]])
            elif command == "lattice":
                lattice = rest
            elif command == "create_atoms" and lattice:
                place = scene.box if rest[1:2] == ["box"] else regions.get(rest[2]) if len(rest) > 2 else None
                filled.append(dem_lattice.positions(lattice, place, scene.box))
            elif command == "pair_style":
                scene.stiffness_N_m = _pair_stiffness(rest, scene.stiffness_N_m)
                scene.tangential_stiffness_N_m = _after(rest, "ks", scene.tangential_stiffness_N_m)
                scene.own_law = "linear" in rest[rest.index("model") + 1:][:1] if "model" in rest else False
            elif command == "set":
                diameter = _after(rest, "diameter", diameter)
                density = _after(rest, "density", density)
            elif command == "fix" and len(rest) >= 3:
                scene.gravity |= rest[2] == "gravity"
                if rest[2].startswith("property/global") and rest[3:4] in (["kn"], ["kt"]):
                    largest = max(filter(math.isfinite, map(_number, rest[6:])), default=None)
                    if rest[3] == "kn":
                        scene.stiffness_N_m = largest
                    else:
                        scene.tangential_stiffness_N_m = largest
            scene.creates |= bool(set(words[:4]) & set(CREATORS))
    groups = ([np.array(singles)] if singles else []) + filled
    if groups and scene.positions is None:
        # a line may run many times, and what is made may be thinned out
        told = not any(words[0] in ("jump", "delete_atoms") for words in scene.commands)
        scene.positions = np.concatenate(groups) if told and all(g is not None for g in groups) else None
        if scene.positions is not None and diameter is not None:
            scene.diameters = np.full(len(scene.positions), diameter)
        if scene.positions is not None and density is not None:
            scene.densities = np.full(len(scene.positions), density)
    # Of particles that are not counted, the one size that `set` gives.
    if scene.diameters is None and scene.positions is None and diameter is not None:
        scene.diameters = np.array([diameter])
    if scene.densities is None and scene.positions is None and density is not None:
        scene.densities = np.array([density])
    return scene


def _lines(file: Path, variables: dict[str, str], base: Path, depth: int = 0):
    """The commands of a script as words, variables put in, includes followed."""
    if depth > 20:
        raise InputError(file, "include", None, "goes round in a circle; include no file in itself")
    text = _text(file)
    for line in re.sub(r"&\s*\n", " ", text).splitlines():
        words = substitute(line.split("#")[0], variables).replace('"', " ").split()
        if words and words[0] == "include" and len(words) == 2 and (base / words[1]).is_file():
            yield from _lines(base / words[1], variables, base, depth + 1)
        elif words:
            yield words


def _text(file: Path) -> str:
    try:
        return file.read_text()
    except OSError as error:
        raise InputError(file, "script", None, f"cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise InputError(file, f"byte {error.start}", None, "is no text; restore the file") from error


def _set_variable(variables: dict[str, str], rest: list[str]) -> None:
    name, style, value = rest[0], rest[1], rest[2]
    if style in ("index", "string"):
        variables.setdefault(name, value)
    elif style == "equal":
        try:
            variables[name] = repr(evaluate("".join(rest[2:]), variables))
        except ValueError:
            variables.pop(name, None)


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return math.nan


def _block(words: list[str]) -> np.ndarray:
    values = np.array([_number(w) for w in words])
    return np.array([values[0::2], values[1::2]])


def _after(words: list[str], key: str, otherwise: float | None) -> float | None:
    if key in words[:-1]:
        value = _number(words[words.index(key) + 1])
        return value if math.isfinite(value) else otherwise
    return otherwise


def _pair_stiffness(rest: list[str], otherwise: float | None) -> float | None:
    """kn of a pair style: named in slidewave's own laws, the first number in LAMMPS' gran/hooke."""
    if rest[:1] and rest[0].startswith("gran/hooke") and len(rest) > 1:
        value = _number(rest[1])
        return value if math.isfinite(value) else otherwise
    return _after(rest, "kn", otherwise)


def _read_data(path: Path, scene: DemScene) -> None:
    """Box and atoms of a data file with atom style granular or sphere: id type diameter density x y z."""
    if not path.is_file():
        raise InputError(path, "read_data", None, "no such file; the script reads it")
    text = _text(path)
    bounds = [re.search(rf"^\s*(\S+)\s+(\S+)\s+{a}lo\s+{a}hi", text, flags=re.M) for a in "xyz"]
    if all(bounds):
        try:
            scene.box = np.array([[float(b.group(k)) for b in bounds] for k in (1, 2)])
        except ValueError as error:
            raise InputError(path, "xlo xhi", None, f"each line needs two numbers ({error})") from error
    atoms = re.search(r"^\s*Atoms\b[^\n]*\n(.*?)(?=^\s*[A-Z]|\Z)", text, flags=re.M | re.S)
    if not atoms or not atoms.group(1).strip():
        scene.positions = np.empty((0, 3))
        scene.diameters = scene.densities = np.empty(0)
        return
    try:
        _take_atoms(atoms.group(1), scene)
    except (ValueError, IndexError) as error:
        raise InputError(path, "Atoms", None, f"each line needs id type diameter density x y z ({error})") from error


def _take_atoms(text: str, scene: DemScene) -> None:
    columns = len(text.strip().split("\n", 1)[0].split())
    rows = np.array(text.split(), dtype=float).reshape(-1, columns)
    scene.diameters, scene.densities, scene.positions = rows[:, 2], rows[:, 3], rows[:, 4:7]
