"""The two sides know the coupler and never each other; the coupler knows no engine; the API is small."""

import re
import sys
from pathlib import Path

ROOT = Path(sys.argv[1])
SOURCES = {".cpp", ".hpp", ".C", ".H", ".h"}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def files(folder):
    return [path for path in (ROOT / folder).rglob("*") if path.suffix in SOURCES]


def includes(folder):
    for path in files(folder):
        for name in INCLUDE.findall(path.read_text(errors="replace")):
            yield path.relative_to(ROOT), name


def own_headers(folder):
    return {path.name for path in files(folder) if path.suffix in {".hpp", ".h", ".H"}}


def main():
    wrong = []
    foam, dem, inner = own_headers("foam_side"), own_headers("dem_side"), own_headers("coupler/src")
    for side, foreign in (("foam_side", dem - foam), ("dem_side", foam - dem)):
        for path, name in includes(side):
            last = name.rsplit("/", 1)[-1]
            if last in foreign or "foam_side" in name or "dem_side" in name:
                wrong.append(f"{path} includes {name} of the other side")
            if last in inner and not name.startswith("slidewave/") and last not in foam | dem:
                wrong.append(f"{path} includes {name}, which is private to the coupler")
            if side == "dem_side" and name in {"fvCFD.H", "Pstream.H"}:
                wrong.append(f"{path} includes OpenFOAM's {name}")
            if side == "foam_side" and name.startswith("liggghts"):
                wrong.append(f"{path} includes LIGGGHTS' {name}")
    for path, name in includes("coupler"):
        last = name.rsplit("/", 1)[-1]
        if "_side" in name or name.endswith(".H") or last in (foam | dem) - inner - own_headers("coupler"):
            wrong.append(f"{path} includes {name}: the coupler knows no engine")
    api = (ROOT / "coupler/include/slidewave/coupler.hpp").read_text().splitlines()
    code = [line for line in api if line.strip() and not line.strip().startswith("//")]
    if len(code) > 100:
        wrong.append(f"coupler.hpp has {len(code)} lines of code, more than 100")
    print("\n".join(wrong) or "layers are clean")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
