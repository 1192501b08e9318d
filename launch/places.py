"""Where things are: the source tree, the build, the installed OpenFOAM."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

from launch import __version__

ROOT = Path(__file__).resolve().parent.parent


def build_dir() -> Path:
    """Build directory: SLIDEWAVE_BUILD, else build/ in the source tree."""
    return Path(os.environ.get("SLIDEWAVE_BUILD", ROOT / "build"))


def program(name: str) -> Path:
    """Full path of one of our executables (which need not be built yet)."""
    return build_dir() / "bin" / name


def cache_dir() -> Path:
    """Results that are kept between runs, by content hash: SLIDEWAVE_CACHE, else .cache/."""
    return Path(os.environ.get("SLIDEWAVE_CACHE", ROOT / ".cache"))


def openfoam_environment() -> dict[str, str]:
    """The environment for OpenFOAM's programs, which Debian leaves without WM_PROJECT_DIR."""
    environment = dict(os.environ)
    environment.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    return environment


def version() -> str:
    """Version of slidewave with the commit, "-dirty" where the tree has changes."""
    try:
        described = subprocess.run(
            ["git", "-C", str(ROOT), "describe", "--always", "--dirty"],
            capture_output=True, text=True, timeout=10, check=True)
    except (OSError, subprocess.SubprocessError):
        return __version__
    return f"{__version__}+{described.stdout.strip()}"
