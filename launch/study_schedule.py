"""Goes through the runs of a study, --jobs at a time, and tells how long the rest will take."""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Future, ThreadPoolExecutor, wait

from launch.progress import say
from launch.study_runner import Job, Runner, is_complete


def duration(seconds: float) -> str:
    """A time for people: 42 s, 3.5 min, 2.1 h."""
    if seconds < 120:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.1f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def run_all(jobs: list[Job], runner: Runner, at_once: int, note: Callable[[Job, str], None]) -> None:
    """Runs every job that is not complete. `note(job, reason)` is called after each, in this thread;
    reason is "" for a good end. A job that fails, for whatever reason, does not stop the others."""
    left = [job for job in jobs if not is_complete(job.directory)]
    if len(left) < len(jobs):
        say(f"{len(jobs) - len(left)} of {len(jobs)} runs are complete already and are kept")
    start, done_windows, done = time.monotonic(), 0.0, 0
    with ThreadPoolExecutor(at_once) as pool:
        running: dict[Future, Job] = {}
        queue = list(left)
        try:
            while queue or running:
                while queue and len(running) < at_once:
                    job = queue.pop(0)
                    running[pool.submit(runner, job.point, job.directory)] = job
                finished, _ = wait(running, return_when=FIRST_COMPLETED)
                for future in finished:
                    job = running.pop(future)
                    reason = _outcome(future, job)
                    done, done_windows = done + 1, done_windows + job.windows
                    note(job, reason)
                    pace = (time.monotonic() - start) / done_windows
                    ahead = sum(j.windows for j in (*queue, *running.values()))
                    rest = f", about {duration(pace * ahead)} left" if ahead else ""
                    say(f"[{done}/{len(left)}] {job.point.label}: {reason or 'done'}{rest}")
        except BaseException:
            stop = getattr(runner, "stop", None)
            if stop:
                stop()
            raise


def _outcome(future: Future, job: Job) -> str:
    """The runner's answer; an error in it counts as a failure of this job alone."""
    error = future.exception()
    if error is not None:
        return f"{type(error).__name__}: {error}"
    return future.result() or ("" if is_complete(job.directory) else "left no complete summary.json")
