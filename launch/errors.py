"""The two ways in which slidewave refuses: bad input (exit 2) and a scene that would run badly (exit 1)."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path


class InputError(Exception):
    """Something a user can mend: which file, which key, its value, and the remedy. Exit status 2."""

    def __init__(self, file: Path | str, key: str, value: object, remedy: str) -> None:
        self.file, self.key, self.value, self.remedy = str(file), key, value, remedy
        shown = "" if value is None else f" = {value!r}"
        super().__init__(f"{self.file}: {key}{shown}: {remedy}")


class RunError(Exception):
    """A run, a build or a utility went wrong, or would go badly. Exit status 1."""


def edit_distance(a: str, b: str) -> int:
    """Least number of inserted, removed or replaced characters that turns `a` into `b`."""
    previous = list(range(len(b) + 1))
    for i, ca in enumerate(a, start=1):
        current = [i]
        for j, cb in enumerate(b, start=1):
            current.append(min(previous[j] + 1, current[-1] + 1, previous[j - 1] + (ca != cb)))
        previous = current
    return previous[-1]


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """" did you mean ...?" with the closest known word, or "" where none is close."""
    best = min(known, key=lambda k: edit_distance(word, k), default=None)
    if best is None or edit_distance(word, best) > max(2, len(word) // 3):
        return ""
    return f"did you mean {best!r}?"
