"""A case: case.toml with a variant laid over it, --set values, and every key checked."""

from __future__ import annotations

import copy
import re
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from launch.errors import InputError, did_you_mean
from launch.overlay import apply_setting, overlay
from launch.places import ROOT
from launch.validate import check_keys, check_tables

DEFAULTS = {
    "case.title": "",
    "coupling.scheme": "serial",
    "coupling.regime": "auto",
    "coupling.patience": 600.0,
    "coupling.reaction": "two_way",
    "coupling.outside": "error",
    "models.drag": "di_felice",
    "models.drag_coefficient": "brown_lawler",
    "models.formulation": "A",
    "models.contact_scaling": "none",
    "fluid.engine": "openfoam",
    "dem.engine": "liggghts",
    "parameters.coarse_grain": 1.0,
}


@dataclass
class Case:
    """A resolved case. `data` is what DIR/case.toml will hold; `used` are parameters named by "$x"."""

    directory: Path
    variant: str
    data: dict
    used: set[str] = field(default_factory=set)

    @property
    def file(self) -> Path:
        return self.directory / "case.toml"

    @property
    def name(self) -> str:
        return self.data["case"]["name"]

    @property
    def parameters(self) -> dict[str, int | float | str]:
        return self.data.get("parameters", {})

    def get(self, dotted: str, otherwise: object = None) -> object:
        """Value of a dotted key, `otherwise` where there is none."""
        value: object = self.data
        for word in dotted.split("."):
            if not isinstance(value, dict) or word not in value:
                return otherwise
            value = value[word]
        return value

    def put(self, dotted: str, value: object) -> None:
        """Sets a dotted key, making the tables on the way."""
        table = self.data
        *words, last = dotted.split(".")
        for word in words:
            table = table.setdefault(word, {})
        table[last] = value

    def error(self, key: str, remedy: str) -> InputError:
        """An InputError about one key of this case."""
        return InputError(self.file, key, self.get(key), remedy)


def find_case(argument: str) -> Path:
    """The directory of a case given as a directory, its case.toml, or a name below cases/."""
    path = Path(argument)
    if path.name == "case.toml":
        path = path.parent
    for candidate in (path, ROOT / "cases" / argument):
        if (candidate / "case.toml").is_file():
            return candidate.resolve()
    names = [p.parent.name for p in sorted(ROOT.glob("cases/*/case.toml"))]
    guess = did_you_mean(path.name, names) or f"known: {', '.join(names)}"
    raise InputError(argument, "CASE", None, f"holds no case.toml; {guess}")


def resolve_names(value: object, parameters: dict, used: set[str], file: Path) -> object:
    """Replaces every text "$name" by that parameter's value, so that a number stands once."""
    if isinstance(value, dict):
        return {k: resolve_names(v, parameters, used, file) for k, v in value.items()}
    if isinstance(value, list):
        return [resolve_names(v, parameters, used, file) for v in value]
    if isinstance(value, str) and re.fullmatch(r"\$\w+", value):
        name = value[1:]
        if name not in parameters:
            remedy = f"no such parameter; {did_you_mean(name, parameters) or 'add it to [parameters]'}"
            raise InputError(file, "parameters", value, remedy)
        used.add(name)
        return parameters[name]
    return value


def read_toml(file: Path) -> dict:
    """Parses a file, with the place of a syntax error in the message."""
    try:
        return tomllib.loads(file.read_text(encoding="utf-8"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise InputError(file, "TOML", None, f"cannot be read: {error}") from error
    except OSError as error:
        raise InputError(file, "file", None, f"cannot be read: {error.strerror}") from error


def load(argument: str, variant: str | None = None, settings: list[str] | None = None) -> Case:
    """Reads a case, lays the variant and the settings over it, checks every key, fills defaults.
    Variants that are not chosen are checked too."""
    directory = find_case(argument)
    file = directory / "case.toml"
    data = read_toml(file)
    check_tables(file, data)
    if "run" in data:
        raise InputError(file, "run", None, "unknown table; slidewave writes it into run directories")
    variants = data.pop("variant", {})
    for name, table in variants.items():
        if not isinstance(table, dict):
            raise InputError(file, f"variant.{name}", table, f"write a table: [variant.{name}]")
        check_tables(file, table)
    chosen = variant or data.get("case", {}).get("default_variant", "")
    if chosen and chosen not in variants:
        guess = did_you_mean(chosen, variants) or f"known: {', '.join(variants) or 'none'}"
        raise InputError(file, "variant", chosen, f"no such variant; {guess}")
    for name in variants:
        if name != chosen:
            _resolve(file, overlay(data, variants[name]))
    merged = copy.deepcopy(overlay(data, variants.get(chosen, {})))
    for text in settings or []:
        apply_setting(merged, text)
    case = Case(directory, chosen, *_resolve(file, merged))
    for key, value in DEFAULTS.items():
        if case.get(key) is None:
            case.put(key, value)
    if case.get("models.pressure_gradient") is None:
        case.put("models.pressure_gradient", case.get("models.formulation") == "A")
    return case


def _resolve(file: Path, data: dict) -> tuple[dict, set[str]]:
    """Puts values for "$name" and checks every key. Gives the tables and the names used."""
    used: set[str] = set()
    parameters = data.get("parameters", {})
    tables = {k: v if k == "parameters" else resolve_names(v, parameters, used, file)
              for k, v in data.items()}
    check_keys(file, tables)
    return tables, used
