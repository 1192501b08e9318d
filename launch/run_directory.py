"""The run directory: made, refused, or an older one kept aside. No result is lost silently."""

from __future__ import annotations

import shutil
from dataclasses import dataclass
from pathlib import Path

from launch.errors import InputError


def holds_run(directory: Path) -> bool:
    """Whether slidewave wrote this directory."""
    file = directory / "case.toml"
    return file.is_file() and "\n[run]\n" in file.read_text(errors="replace")


@dataclass
class Place:
    """An empty run directory, and where the run that it held before is kept, if any."""

    directory: Path
    kept: Path | None = None
    made: bool = True

    def withdraw(self) -> None:
        """Takes back what make() did, for input that is refused while preparing."""
        shutil.rmtree(self.directory, ignore_errors=True)
        if self.kept is not None:
            self.kept.rename(self.directory)
        elif not self.made:
            self.directory.mkdir()


def place_of(out: Path | None, case_name: str, variant: str) -> Path:
    """Where a run of a case goes: `out`, else runs/<case>-<variant>."""
    return (out or Path("runs") / (f"{case_name}-{variant}" if variant else case_name)).absolute()


def make(out: Path | None, case_name: str, variant: str, overwrite: bool) -> Place:
    """An empty run directory: `out`, else runs/<case>-<variant>, where an older run is kept as .1, .2."""
    directory = place_of(out, case_name, variant)
    existed, kept = directory.is_dir(), None
    if directory.exists() and not existed:
        raise InputError(directory, "--out", None, "is a file; give a directory")
    if existed and any(directory.iterdir()):
        if overwrite:
            if not holds_run(directory):
                raise InputError(directory, "--overwrite", None,
                                 "holds files but no run of slidewave; will not delete them")
            shutil.rmtree(directory)
        elif out is None:
            kept = _keep(directory)
        else:
            raise InputError(directory, "--out", None, "holds files already; give another place, "
                             "or --overwrite to replace a run")
    directory.mkdir(parents=True, exist_ok=True)
    return Place(directory, kept, made=not existed)


def _keep(directory: Path) -> Path:
    """Renames a run to the first free number and tells where it went."""
    number = 1
    while directory.with_name(f"{directory.name}.{number}").exists():
        number += 1
    return directory.rename(directory.with_name(f"{directory.name}.{number}"))
