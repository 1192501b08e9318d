"""What a scene of the stability map is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

History = dict[str, np.ndarray]


@dataclass(frozen=True)
class Scene:
    """A case with settings (dotted keys), and what a run of it is judged by.

    `error`: relative error of a finished run against a reference that is not slidewave's; None where
    there is none. `finer`: settings of a run that stands for the truth instead, with the column that is
    compared over the time that both cover, over its largest change. `speed`: largest mean-square
    speed [m/s] that the scene's energy allows; above twice that it has blown up. `mass`: of all
    particles that move [kg]. `lost`: whether particles may leave. `ranks`: fluid and particle ranks.
    """

    group: str
    name: str
    case: str
    settings: dict[str, object]
    speed: float = np.inf
    mass: float = 0.0
    error: Callable[[History], float] | None = None
    finer: dict[str, object] | None = None
    finer_ranks: tuple[int, int] = (1, 1)
    column: str = ""
    lost: bool = False
    ranks: tuple[int, int] = (1, 1)
    quick: bool = field(default=False)

    @property
    def title(self) -> str:
        return f"{self.group}: {self.name}"

    def words(self, more: dict[str, object] | None = None) -> list[str]:
        """The settings as options of the command line."""
        found = []
        for key, value in (self.settings | (more or {})).items():
            text = str(value).lower() if isinstance(value, bool) else str(value)
            found += ["--set", f"{key}={text}"]
        return found
