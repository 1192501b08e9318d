"""Every engine knows the coupler and never another engine; the coupler knows no engine; the API is small."""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1])
SIDES = ("foam_side", "dem_side", "dem_lammps", "dem_esys")
SOURCES = {".cpp", ".hpp", ".C", ".H", ".h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def files(folder):
    return [path for path in (ROOT / folder).rglob("*") if path.suffix in SOURCES]


def includes(folder):
    for path in files(folder):
        for name in INCLUDE.findall(path.read_text(errors="replace")):
            yield path.relative_to(ROOT), name


def own_headers(folder):
    """Names of a folder's headers, without stand-ins for those of a package."""
    return {path.name for path in files(folder)
            if path.suffix in {".hpp", ".h", ".H"} and "unpackaged" not in path.parts}


def main():
    wrong = []
    headers = {side: own_headers(side) for side in SIDES}
    engines = set().union(*headers.values())
    inner = own_headers("coupler/src")
    for side in SIDES:
        foreign = engines - headers[side]
        others = [other for other in SIDES if other != side]
        for path, name in includes(side):
            last = name.rsplit("/", 1)[-1]
            if last in foreign or any(other in name for other in others):
                wrong.append(f"{path} includes {name} of another engine")
            if last in inner and not name.startswith("slidewave/") and last not in engines:
                wrong.append(f"{path} includes {name}, which is private to the coupler")
            if side != "foam_side" and name in {"fvCFD.H", "Pstream.H"}:
                wrong.append(f"{path} includes OpenFOAM's {name}")
            if side != "dem_side" and name.startswith("liggghts"):
                wrong.append(f"{path} includes LIGGGHTS' {name}")
    for path, name in includes("coupler"):
        last = name.rsplit("/", 1)[-1]
        if any(side in name for side in SIDES) or name.endswith(".H") or \
                last in engines - inner - own_headers("coupler"):
            wrong.append(f"{path} includes {name}: the coupler knows no engine")
    api = (ROOT / "coupler/include/slidewave/coupler.hpp").read_text().splitlines()
    code = [line for line in api if line.strip() and not line.strip().startswith("//")]
    if len(code) > 100:
        wrong.append(f"coupler.hpp has {len(code)} lines of code, more than 100")
    print("\n".join(wrong) or "layers are clean")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
