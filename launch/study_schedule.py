"""Goes through the runs of a study, --jobs at a time, and tells how long the rest will take."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait
from dataclasses import dataclass

from launch.progress import say
from launch.results import read_summary
from launch.study_runner import Job, Runner, is_complete


def duration(seconds: float) -> str:
    """A time for people: 42 s, 3.5 min, 2.1 h."""
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.1f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


@dataclass
class Pace:
    """What runs took so far: the part that grows with the windows, and the rest of each run [s]."""

    runs: int = 0
    windows: float = 0.0
    coupled_s: float = 0.0
    other_s: float = 0.0

    def learn(self, job: Job, took_s: float) -> None:
        """Takes in a run that ended well."""
        wall_s = min(took_s, float(read_summary(job.directory).get("wall_s") or 0))
        self.runs, self.windows = self.runs + 1, self.windows + job.windows
        self.coupled_s, self.other_s = self.coupled_s + wall_s, self.other_s + took_s - wall_s

    def ahead(self, jobs: list[Job], at_once: int) -> str:
        """", about 3.5 min left" for the jobs still to do, "" where nothing is known or left."""
        if not self.runs or not jobs:
            return ""
        windows = sum(job.windows for job in jobs)
        left_s = self.other_s / self.runs * len(jobs) + self.coupled_s / self.windows * windows
        return f", about {duration(left_s / at_once)} left"


def run_all(jobs: list[Job], runner: Runner, at_once: int, note: Callable[[Job, str], None]) -> None:
    """Runs every job that is not complete. `note(job, reason)` is called after each, in this thread;
    reason is "" for a good end. A job that fails, for whatever reason, does not stop the others."""
    left = [job for job in jobs if not is_complete(job.directory)]
    if len(left) < len(jobs):
        say(f"{len(jobs) - len(left)} of {len(jobs)} runs are complete already and are kept")
    pace, done = Pace(), 0
    with ThreadPoolExecutor(at_once) as pool:
        running: dict[Future, Job] = {}
        queue = list(left)
        try:
            while queue or running:
                while queue and len(running) < at_once:
                    job = queue.pop(0)
                    running[pool.submit(_timed, runner, job)] = job
                finished, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in finished:
                    job = running.pop(future)
                    reason, took_s = future.result()
                    if not reason:
                        pace.learn(job, took_s)
                    done += 1
                    note(job, reason)
                    rest = pace.ahead([*queue, *running.values()], at_once)
                    say(f"[{done}/{len(left)}] {job.point.label}: {reason or 'done'}{rest}")
        except BaseException:
            stop = getattr(runner, "stop", None)
            if stop:
                stop()
            raise


def _timed(runner: Runner, job: Job) -> tuple[str, float]:
    """The runner's answer and the time it took [s]; an error in it is a failure of this job alone."""
    start = time.monotonic()
    try:
        reason = runner(job.point, job.directory)
    except Exception as error:
        reason = f"{type(error).__name__}: {error}"
    if not reason and not is_complete(job.directory):
        reason = "left no complete summary.json"
    return reason, time.monotonic() - start
